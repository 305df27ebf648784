// The value of an operand as a person or a program reads it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "address/reference.h"
#include "plc/controller.h"

namespace merker::simulator {

// Bits as 0 and 1, bytes, words and double words as B#16#, W#16#, DW#16#, typed variables in their
// type's own notation, timers (as LC loads them) as S5T#, counters as C#; those of STEP 5 as KT,
// KZ.
std::string formatOperand(const address::Reference& reference, std::uint32_t bits);

// A timer or counter of STEP 5: its type is the word that LC loads.
bool isStep5Cell(const address::Reference& reference);
// "KT 500.1", "KZ 12": that word as a listing writes it.
std::string formatTimeConstant(std::uint32_t bits);
std::string formatCountConstant(std::uint32_t bits);

// What the operand holds now, in the same notation, and DATE_AND_TIME and STRING in theirs; nothing
// if it does not exist.
std::optional<std::string> show(const address::Reference& reference,
                                const controller::Controller& plc);

// The same as a number or truth value: INT and DINT with sign, REAL, TIME, S5TIME and timers in
// milliseconds, TOD in milliseconds, DATE in days since 1990-01-01, counters as their count; all
// else unsigned.
std::variant<bool, std::int64_t, double> numericValue(const address::Reference& reference,
                                                      std::uint32_t bits);

}  // namespace merker::simulator
