// Messages as objects of a request or an indication: 12h, length, syntax, values, number.
#pragma once

#include "s7comm/pdu.h"

namespace merker::s7comm {

enum class ObjectSyntax : std::uint8_t {
  Lock = 0x15,
  Indication = 0x16,
  Acknowledgement = 0x19,
  Query = 0x1A
};
constexpr std::uint8_t kVariableObject = 0x12;

void appendObject(Bytes& data, ObjectSyntax syntax, std::uint8_t values, std::uint32_t number);

}  // namespace merker::s7comm
