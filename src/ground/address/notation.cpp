#include "address/notation.h"

#include <algorithm>

namespace merker::notation {
namespace {

// The value of a digit, 99 for any other character.
unsigned digitValue(char c) {
  if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0');
  if (c >= 'A' && c <= 'F') return static_cast<unsigned>(c - 'A' + 10);
  return 99;
}

}  // namespace

Problem unknown(const Input& input, std::string_view hint) {
  return makeProblem(ProblemCode::P0201, input.at, input.written, hint);
}
Problem outside(const Input& input, std::string_view range) {
  return makeProblem(ProblemCode::P0202, input.at, input.written, range);
}
Problem misspelt(const Input& input, std::string_view example) {
  return makeProblem(ProblemCode::P0205, input.at, input.written, example);
}

bool Scanner::take(std::string_view expected) {
  if (!text_.starts_with(expected)) return false;
  text_.remove_prefix(expected.size());
  return true;
}

std::optional<std::uint64_t> Scanner::number(unsigned base) {
  std::uint64_t value = 0;
  digits_ = 0;
  for (; digits_ < text_.size() && digitValue(text_[digits_]) < base; ++digits_)
    value = std::min(value * base + digitValue(text_[digits_]), kHuge);
  text_.remove_prefix(digits_);
  if (digits_ == 0) return std::nullopt;
  return value;
}

std::string_view Scanner::letters() {
  std::size_t length = 0;
  while (length < text_.size() && text_[length] >= 'A' && text_[length] <= 'Z') ++length;
  const std::string_view result = text_.substr(0, length);
  text_.remove_prefix(length);
  return result;
}

void Scanner::skipBlanks() {
  while (take(" ") || take("\t")) {
  }
}

}  // namespace merker::notation
