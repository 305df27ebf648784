// Start values of declarations and actual values of data blocks: text to bytes of the variable.
#pragma once

#include <optional>
#include <vector>

#include "address/constant.h"
#include "block/type.h"
#include "source/source_file.h"
#include "step7/cursor.h"

namespace merker::step7 {

// The value of `type` written in [begin, end) of the file: one constant, a list with repetition
// factors for an array (1, 2, 5 (0)), a string, DT#…, a timer, counter or block for those parameter
// types. Nothing after a problem.
std::optional<std::vector<std::uint8_t>> readInitialValue(const block::Type& type,
                                                          const source::SourceFile& file,
                                                          std::size_t begin, std::size_t end,
                                                          Mnemonics mnemonics, Problems& problems);

// Converts a constant to the bits of an elementary type, as a declaration or a CALL accepts it: 500
// for INT, W#16#… for WORD, 5 for BYTE if it fits, … Nothing if it does not fit the type.
std::optional<std::uint32_t> convertConstant(const Constant& constant, TypeCode type);

// Whether the notation states more bits than the type has.
bool tooWide(ConstantFormat format, TypeCode type);

// Writes `bits` of an elementary value at bit address `at` of the frame.
void storeElementary(std::vector<std::uint8_t>& image, BitAddress at, TypeCode type,
                     std::uint32_t bits);

}  // namespace merker::step7
