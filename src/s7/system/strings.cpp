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
template <typename A>
Numbers numbers(A& a, NameIn<A> length, NameIn<A> position) {
  const std::int32_t l = a.integer(length), p = a.integer(position);
  if (l >= 0 && p >= 0) return {true, static_cast<std::size_t>(l), static_cast<std::size_t>(p)};
  a.fail();
  return {};
}

// The same of one number, which is both.
template <typename A>
Numbers numbers(A& a, NameIn<A> only) {
  return numbers(a, only, only);
}

// By the characters' codes; of two that are equal so far the longer is greater.
template <typename Relation, typename A>
void compare(A& a) {
  a.set("RET_VAL", Relation{}(getText(a, "S1").compare(getText(a, "S2")), 0));
}

}  // namespace

void concatenate(Fc<2>& a) { setText(a, "RET_VAL", getText(a, "IN1") + getText(a, "IN2")); }

// L = 0, P = 0 and P behind the end leave the string as it is; more than there is ends at its end.
void deleteText(Fc<4>& a) {
  std::string text = getText(a, "IN");
  const Numbers n = numbers(a, "L", "P");
  if (!n.valid) text.clear();
  if (n.position >= 1 && n.position <= text.size()) text.erase(n.position - 1, n.length);
  setText(a, "RET_VAL", text);
}

// The block of the library clears BIE for two equal strings, which it finds at 1.
void findText(Fc<11>& a) {
  const std::string text = getText(a, "IN1"), part = getText(a, "IN2");
  const std::size_t at = part.empty() ? std::string::npos : text.find(part);
  if (text == part) a.fail();
  a.set("RET_VAL", at == std::string::npos ? 0 : static_cast<std::uint32_t>(at + 1));
}

// Behind position P; 0 is in front, behind the end means at the end.
void insertText(Fc<17>& a) {
  const std::string text = getText(a, "IN1"), part = getText(a, "IN2");
  const Numbers n = numbers(a, "P");
  const std::size_t at = std::min(n.position, text.size());
  setText(a, "RET_VAL", n.valid ? text.substr(0, at) + part + text.substr(at) : std::string());
}

void leftOfText(Fc<20>& a) {
  const std::string text = getText(a, "IN");
  setText(a, "RET_VAL", text.substr(0, numbers(a, "L").length));
}

void rightOfText(Fc<32>& a) {
  const std::string text = getText(a, "IN");
  const std::size_t length = std::min(numbers(a, "L").length, text.size());
  setText(a, "RET_VAL", text.substr(text.size() - length));
}

// The second byte, whatever the first one says: it reports no error.
void lengthOfText(Fc<21>& a) {
  const Region head = a.composite("S", 2, cpu::Access::Read);
  a.set("RET_VAL", head ? head.data[1] : 0u);
}

// L = 0, P = 0 and P behind the end are errors; more than there is ends at the string's end.
void middleOfText(Fc<26>& a) {
  const std::string text = getText(a, "IN");
  const Numbers n = numbers(a, "L", "P");
  const bool inside = n.length >= 1 && n.position >= 1 && n.position <= text.size();
  if (!inside) a.fail();
  setText(a, "RET_VAL", inside ? text.substr(n.position - 1, n.length) : std::string());
}

// L = 0 leaves the string as it is; P = 0 is P = 1; behind the end the other string is appended.
void replaceText(Fc<31>& a) {
  const std::string text = getText(a, "IN1"), part = getText(a, "IN2");
  const Numbers n = numbers(a, "L", "P");
  if (!n.valid || n.length == 0) return setText(a, "RET_VAL", n.valid ? text : std::string());
  const std::size_t at = std::min(n.position == 0 ? 0 : n.position - 1, text.size());
  const std::size_t behind = std::min(at + n.length, text.size());
  setText(a, "RET_VAL", text.substr(0, at) + part + text.substr(behind));
}

void textEqual(Fc<10>& a) { compare<std::equal_to<int>>(a); }
void textGreaterEqual(Fc<13>& a) { compare<std::greater_equal<int>>(a); }
void textGreater(Fc<15>& a) { compare<std::greater<int>>(a); }
void textLessEqual(Fc<19>& a) { compare<std::less_equal<int>>(a); }
void textLess(Fc<24>& a) { compare<std::less<int>>(a); }
void textNotEqual(Fc<29>& a) { compare<std::not_equal_to<int>>(a); }

}  // namespace merker::system
