// Constants in AWL notation: text to bits and back (S7-TYPES, S7-LOAD, S7-MNE-14).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "address/area.h"
#include "address/type_code.h"
#include "base/result.h"

namespace merker {

// How a constant was written. MC7 keeps it beside the value so that an editor shows it again (MC7
// section 3).
enum class ConstantFormat : std::uint8_t {
  Boolean,         // TRUE, FALSE                                   (never in L)
  Byte,            // B#16#A1
  Binary,          // 2#1010, up to 16 digits
  Integer,         // -12123
  Characters,      // 'ab', up to 2
  Bytes,           // B#(1,2)
  Word,            // W#16#ABCD
  Counter,         // C#128
  Date,            // D#1998-04-14
  S5Time,          // S5T#1H10M20S
  Real,            // 12.3, 1.23e+01
  LongBinary,      // 2#… with 17 to 32 digits
  LongInteger,     // L#35434
  Pointer,         // P#M10.0, P#10.0
  LongCharacters,  // 'abc', 'abcd'
  LongBytes,       // B#(1,2,3,4)
  DWord,           // DW#16#12345678
  Time,            // T#14D20H
  TimeOfDay        // TOD#17:53:17.333
};

// 8, 16 or 32: the width that `L` gives it (1 for Boolean).
unsigned bitWidth(ConstantFormat format);

struct Constant {
  ConstantFormat format = ConstantFormat::Integer;
  std::uint32_t bits = 0;  // right-aligned, rest 0; negative INT as 16 bits
  bool operator==(const Constant&) const = default;
};

// The type that a constant of this notation has at a CALL: 'a' CHAR, 12 INT, 1.0 REAL …
TypeCode naturalType(const Constant& constant);

// Reads one constant that fills `text` completely (blanks around # and - allowed as STEP 7 allows
// them). Underscores in digit groups are ignored. Errors: unknown notation (P0201), value out of
// range (P0202), TOD with a colon before the milliseconds (P0203, S7-OPEN-26), more than 4
// characters (P0204). The position of a problem is `at`.
Result<Constant> parseConstant(std::string_view text, const Position& at);

// The value as a source shows it: REAL always exponential (1.230000e+001), S5TIME with the largest
// units (S5T#1H10M20S), P#M10.0 in the given mnemonics (E/A or I/Q). Reading it again gives the
// same bits: a REAL gets more digits where seven are too few, and bits that the notation cannot
// express come out as B#16#, W#16# or DW#16#.
std::string formatConstant(const Constant& constant, Mnemonics mnemonics = Mnemonics::German);

// An elementary value as STEP 7 displays it, in the notation of its type: INT 5 -> "5", WORD ->
// W#16#0005, TIME -> T#5S, REAL with seven digits. TIMER and COUNTER show as S5TIME and C#.
std::string formatValue(TypeCode type, std::uint32_t bits, Mnemonics mnemonics = Mnemonics::German);

// Characters of a CHAR, STRING or `L 'ab'` with their quotation marks and $ escapes ($$ $' $L $N $P
// $R $T $hh) to one CP1252 byte each, and back. Any length; P0209 says what is wrong.
Result<std::string> parseCharacters(std::string_view quoted, const Position& at);
std::string formatCharacters(std::string_view cp1252);

// S5TIME of a length in milliseconds: smallest base that holds it, remainder truncated
// (S7-TYPES-10). Nothing above 9990 s; below 10 ms gives 0.
std::optional<std::uint16_t> encodeS5Time(std::uint64_t milliseconds);
// Milliseconds of an S5TIME word; nothing if a digit is above 9.
std::optional<std::uint32_t> decodeS5Time(std::uint16_t s5time);

// DATE_AND_TIME, 8 BCD bytes (S7-TYPES-18), of DT#1998-04-14-17:53:17.333; weekday computed.
Result<std::uint64_t> parseDateAndTime(std::string_view text, const Position& at);
std::string formatDateAndTime(std::uint64_t bcd);

// DATE: days since 1990-01-01. Weekday 1 = Sunday.
std::optional<std::uint16_t> daysSince1990(int year, int month, int day);
void dateFromDays(std::uint16_t days, int& year, int& month, int& day);
int weekday(std::uint16_t days);

}  // namespace merker
