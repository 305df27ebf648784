// Values that no double word holds: DATE_AND_TIME, STRING, and the NC's numbers with a point. Their
// content is a text of bytes: the eight of a DATE_AND_TIME, the characters of a STRING in CP1252,
// the digits of a number.
#pragma once

#include <optional>
#include <string>

#include "plc/controller.h"
#include "scenario/term.h"

namespace merker::simulator {

inline bool isLong(const address::Reference& reference) {
  return reference.bytes > 0 || reference.nc != 0;
}
inline bool isLong(const Term& term) { return term.content || isLong(term.reference); }

// The content now; nothing if the operand does not exist.
std::optional<std::string> readLong(const address::Reference& reference,
                                    const controller::Controller& plc);
std::optional<std::string> longValue(const Term& term, const controller::Controller& plc);
// False if the operand does not exist. A STRING must not be longer than declared.
bool writeLong(const address::Reference& reference, const std::string& content,
               controller::Controller& plc);

// DT#1994-01-01-00:00:00.000 or 'text'.
std::string formatLong(TypeCode type, const std::string& content);
// The same without quotation marks, in UTF-8: for JSON.
std::string plainLong(TypeCode type, const std::string& content);
// A constant for an operand of this type; P0960 if it is written like one of another type.
Result<std::string> parseLong(std::string_view text, const address::Reference& reference,
                              const Position& at);
Problem otherNotation(const address::Reference& reference, const Position& at);

// By instant (the weekday does not count), or by characters.
bool longHolds(const Term& left, block::Relation relation, const Term& right,
               const controller::Controller& plc);
// For a message: the left side's value, and the right side's if it is an operand.
std::string actualLong(const Term& left, const Term& right, const controller::Controller& plc);

}  // namespace merker::simulator
