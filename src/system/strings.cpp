// FC 2 CONCAT, 4 DELETE, 11 FIND, 17 INSERT, 20 LEFT, 21 LEN, 26 MID, 31 REPLACE, 32 RIGHT
// (S7-IEC-06), and comparisons (S7-IEC-05). Positions count from 1; an impossible position or
// length makes BIE 0.
#include <algorithm>
#include <functional>

#include "system/text.h"

namespace merker::system {
namespace {

// Number of characters; a negative one is an error.
std::size_t count(Arguments& a, std::size_t i) {
  const std::int32_t value = a.integer(i);
  if (value < 0) a.fail();
  return static_cast<std::size_t>(std::max(value, 0));
}

// Position from 1 as an index; 0 or less is an error and has none.
struct Index {
  bool valid = false;
  std::size_t at = 0;
};
Index index(Arguments& a, std::size_t i, std::size_t length) {
  const std::int32_t position = a.integer(i);
  if (position >= 1 && static_cast<std::size_t>(position) <= length)
    return {true, static_cast<std::size_t>(position) - 1};
  a.fail();
  return {};
}

void concat(Arguments& a) { setText(a, 2, getText(a, 0) + getText(a, 1)); }

void erase(Arguments& a) {
  std::string text = getText(a, 0);
  const std::size_t length = count(a, 1);
  if (const Index from = index(a, 2, text.size()); from.valid) {
    if (length > text.size() - from.at) a.fail();
    text.erase(from.at, length);
  }
  setText(a, 3, text);
}

void find(Arguments& a) {
  const std::string text = getText(a, 0), part = getText(a, 1);
  const std::size_t at = part.empty() ? std::string::npos : text.find(part);
  a.set(2, at == std::string::npos ? 0 : static_cast<std::uint32_t>(at + 1));
}

// Behind position P; 0 is in front.
void insert(Arguments& a) {
  const std::string text = getText(a, 0), part = getText(a, 1);
  const std::size_t position = count(a, 2);
  if (position > text.size()) a.fail();
  const std::size_t at = std::min(position, text.size());
  setText(a, 3, text.substr(0, at) + part + text.substr(at));
}

void left(Arguments& a) {
  const std::string text = getText(a, 0);
  const std::size_t length = count(a, 1);
  setText(a, 2, text.substr(0, length));
}

void right(Arguments& a) {
  const std::string text = getText(a, 0);
  const std::size_t length = std::min(count(a, 1), text.size());
  setText(a, 2, text.substr(text.size() - length));
}

void length(Arguments& a) { a.set(1, static_cast<std::uint32_t>(getText(a, 0).size())); }

void middle(Arguments& a) {
  const std::string text = getText(a, 0);
  const std::size_t characters = count(a, 1);
  const Index from = index(a, 2, text.size());
  if (from.valid && characters > text.size() - from.at) a.fail();
  setText(a, 3, from.valid ? text.substr(from.at, characters) : std::string());
}

void replace(Arguments& a) {
  const std::string text = getText(a, 0), part = getText(a, 1);
  const std::size_t characters = count(a, 2);
  const Index from = index(a, 3, text.size());
  if (!from.valid) return setText(a, 4, text);
  const std::size_t removed = std::min(characters, text.size() - from.at);
  if (removed < characters) a.fail();
  setText(a, 4, text.substr(0, from.at) + part + text.substr(from.at + removed));
}

// By the characters' codes; of two that are equal so far the longer is greater.
template <typename Relation>
void compare(Arguments& a) {
  a.set(2, Relation{}(getText(a, 0).compare(getText(a, 1)), 0));
}

}  // namespace

Functions stringFunctions() {
  using enum TypeCode;
  const Parameter result{"RET_VAL", kReturn, String};
  return {
      {BlockKind::FC, 2, "CONCAT", {{"IN1", kIn, String}, {"IN2", kIn, String}, result}, concat},
      {BlockKind::FC,
       4,
       "DELETE",
       {{"IN", kIn, String}, {"L", kIn, Int}, {"P", kIn, Int}, result},
       erase},
      {BlockKind::FC,
       11,
       "FIND",
       {{"IN1", kIn, String}, {"IN2", kIn, String}, {"RET_VAL", kReturn, Int}},
       find},
      {BlockKind::FC,
       17,
       "INSERT",
       {{"IN1", kIn, String}, {"IN2", kIn, String}, {"P", kIn, Int}, result},
       insert},
      {BlockKind::FC, 20, "LEFT", {{"IN", kIn, String}, {"L", kIn, Int}, result}, left},
      {BlockKind::FC, 21, "LEN", {{"S", kIn, String}, {"RET_VAL", kReturn, Int}}, length},
      {BlockKind::FC,
       26,
       "MID",
       {{"IN", kIn, String}, {"L", kIn, Int}, {"P", kIn, Int}, result},
       middle},
      {BlockKind::FC,
       31,
       "REPLACE",
       {{"IN1", kIn, String}, {"IN2", kIn, String}, {"L", kIn, Int}, {"P", kIn, Int}, result},
       replace},
      {BlockKind::FC, 32, "RIGHT", {{"IN", kIn, String}, {"L", kIn, Int}, result}, right}};
}

Functions stringComparisons() {
  using enum TypeCode;
  const std::vector<Parameter> two{
      {"S1", kIn, String}, {"S2", kIn, String}, {"RET_VAL", kReturn, Bool}};
  return {{BlockKind::FC, 10, "EQ_STRNG", two, compare<std::equal_to<int>>},
          {BlockKind::FC, 13, "GE_STRNG", two, compare<std::greater_equal<int>>},
          {BlockKind::FC, 15, "GT_STRNG", two, compare<std::greater<int>>},
          {BlockKind::FC, 19, "LE_STRNG", two, compare<std::less_equal<int>>},
          {BlockKind::FC, 24, "LT_STRNG", two, compare<std::less<int>>},
          {BlockKind::FC, 29, "NE_STRNG", two, compare<std::not_equal_to<int>>}};
}

}  // namespace merker::system
