// What the readers of the single constant notations share. Internal to this module.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "address/constant.h"

namespace merker::notation {

// One constant on its way from text to bits.
struct Input {
  std::string_view written;  // as the user wrote it, for messages
  std::string_view
      body;  // behind the prefix: upper case, no underscores, no blanks around # - + , : ( )
  const Position& at;
};

Problem unknown(const Input& input, std::string_view hint = {});
Problem outside(const Input& input, std::string_view range);
Problem misspelt(const Input& input, std::string_view example);

// Takes characters from the front of a text.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}
  bool atEnd() const { return text_.empty(); }
  std::string_view rest() const { return text_; }
  bool take(std::string_view expected);
  // Digits of a base; nothing if there are none. Numbers above kHuge come out as kHuge: outside
  // every range.
  std::optional<std::uint64_t> number(unsigned base = 10);
  // The length of the last number in digits.
  std::size_t digits() const { return digits_; }
  std::string_view letters();
  void skipBlanks();
  static constexpr std::uint64_t kHuge = 10'000'000'000;

 private:
  std::string_view text_;
  std::size_t digits_ = 0;
};

// Readers in number_notation.cpp
Result<Constant> readByte(const Input& input);
Result<Constant> readWord(const Input& input);
Result<Constant> readDWord(const Input& input);
Result<Constant> readPlainHexadecimal(const Input& input);  // 16#FF
Result<Constant> readBinary(const Input& input);
Result<Constant> readCounter(const Input& input);
Result<Constant> readPointer(const Input& input);
Result<Constant> readLongInteger(const Input& input);
Result<Constant> readNumber(const Input& input);  // INT or REAL
// Readers in time_notation.cpp
Result<Constant> readS5Time(const Input& input);
Result<Constant> readTime(const Input& input);
Result<Constant> readDate(const Input& input);
Result<Constant> readTimeOfDay(const Input& input);
Result<std::uint64_t> readDateAndTime(const Input& input);

// Writers in time_format.cpp; empty if the notation cannot express the bits.
std::string writeS5Time(std::uint32_t bits);
std::string writeTime(std::uint32_t bits);
std::string writeDate(std::uint32_t days);
std::string writeTimeOfDay(std::uint32_t milliseconds);

}  // namespace merker::notation
