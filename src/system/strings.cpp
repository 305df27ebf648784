// FC 2 CONCAT, 4 DELETE, 11 FIND, 17 INSERT, 20 LEFT, 21 LEN, 26 MID, 31 REPLACE, 32 RIGHT
// (S7-IEC-06), and comparisons (S7-IEC-05). Positions count from 1. What zero, negative and too
// large numbers do stands with each function in Siemens' "System and Standard Functions", IEC
// functions.
#include <algorithm>
#include <functional>

#include "system/text.h"

namespace merker::system {
namespace {

// L and P as numbers. A negative one is an error, and the result is the empty string.
struct Numbers {
  bool valid = false;
  std::size_t length = 0, position = 0;
};
Numbers numbers(Arguments& a, std::size_t length, std::size_t position) {
  const std::int32_t l = a.integer(length), p = a.integer(position);
  if (l >= 0 && p >= 0) return {true, static_cast<std::size_t>(l), static_cast<std::size_t>(p)};
  a.fail();
  return {};
}

// By the characters' codes; of two that are equal so far the longer is greater.
template <typename Relation>
void compare(Arguments& a) {
  a.set(2, Relation{}(getText(a, 0).compare(getText(a, 1)), 0));
}

}  // namespace

void concatenate(Arguments& a) { setText(a, 2, getText(a, 0) + getText(a, 1)); }

// L = 0, P = 0 and P behind the end leave the string as it is; more than there is ends at its end.
void deleteText(Arguments& a) {
  std::string text = getText(a, 0);
  const Numbers n = numbers(a, 1, 2);
  if (!n.valid) text.clear();
  if (n.position >= 1 && n.position <= text.size()) text.erase(n.position - 1, n.length);
  setText(a, 3, text);
}

// The block of the library clears BIE for two equal strings, which it finds at 1.
void findText(Arguments& a) {
  const std::string text = getText(a, 0), part = getText(a, 1);
  const std::size_t at = part.empty() ? std::string::npos : text.find(part);
  if (text == part) a.fail();
  a.set(2, at == std::string::npos ? 0 : static_cast<std::uint32_t>(at + 1));
}

// Behind position P; 0 is in front, behind the end means at the end.
void insertText(Arguments& a) {
  const std::string text = getText(a, 0), part = getText(a, 1);
  const Numbers n = numbers(a, 2, 2);
  const std::size_t at = std::min(n.position, text.size());
  setText(a, 3, n.valid ? text.substr(0, at) + part + text.substr(at) : std::string());
}

void leftOfText(Arguments& a) {
  const std::string text = getText(a, 0);
  setText(a, 2, text.substr(0, numbers(a, 1, 1).length));
}

void rightOfText(Arguments& a) {
  const std::string text = getText(a, 0);
  const std::size_t length = std::min(numbers(a, 1, 1).length, text.size());
  setText(a, 2, text.substr(text.size() - length));
}

// The second byte, whatever the first one says: it reports no error.
void lengthOfText(Arguments& a) {
  const Region head = a.composite(0, 2, cpu::Access::Read);
  a.set(1, head ? head.data[1] : 0u);
}

// L = 0, P = 0 and P behind the end are errors; more than there is ends at the string's end.
void middleOfText(Arguments& a) {
  const std::string text = getText(a, 0);
  const Numbers n = numbers(a, 1, 2);
  const bool inside = n.length >= 1 && n.position >= 1 && n.position <= text.size();
  if (!inside) a.fail();
  setText(a, 3, inside ? text.substr(n.position - 1, n.length) : std::string());
}

// L = 0 leaves the string as it is; P = 0 is P = 1; behind the end the other string is appended.
void replaceText(Arguments& a) {
  const std::string text = getText(a, 0), part = getText(a, 1);
  const Numbers n = numbers(a, 2, 3);
  if (!n.valid || n.length == 0) return setText(a, 4, n.valid ? text : std::string());
  const std::size_t at = std::min(n.position == 0 ? 0 : n.position - 1, text.size());
  const std::size_t behind = std::min(at + n.length, text.size());
  setText(a, 4, text.substr(0, at) + part + text.substr(behind));
}

void textEqual(Arguments& a) { compare<std::equal_to<int>>(a); }
void textGreaterEqual(Arguments& a) { compare<std::greater_equal<int>>(a); }
void textGreater(Arguments& a) { compare<std::greater<int>>(a); }
void textLessEqual(Arguments& a) { compare<std::less_equal<int>>(a); }
void textLess(Arguments& a) { compare<std::less<int>>(a); }
void textNotEqual(Arguments& a) { compare<std::not_equal_to<int>>(a); }

}  // namespace merker::system
