// STRING parameters: byte 0 longest length, byte 1 length, then the characters (S7-TYPES-19).
#pragma once

#include <string>

#include "system/call.h"

namespace merker::system {

// An unreadable or inconsistent STRING counts as empty, BIE 0.
std::string getText(Arguments& a, std::size_t i);
// Cut off where it does not fit; BIE 0 then.
void setText(Arguments& a, std::size_t i, const std::string& text);
// Whole or not at all: where it does not fit the STRING stays as it is, BIE 0.
void setWholeText(Arguments& a, std::size_t i, const std::string& text);

template <typename A>
std::string getText(A& a, NameIn<A> parameter) {
  return getText(a, parameter.index);
}
template <typename A>
void setText(A& a, NameIn<A> parameter, const std::string& text) {
  setText(a, parameter.index, text);
}
template <typename A>
void setWholeText(A& a, NameIn<A> parameter, const std::string& text) {
  setWholeText(a, parameter.index, text);
}

}  // namespace merker::system
