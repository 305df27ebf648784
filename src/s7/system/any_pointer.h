// What an ANY names (S7-IND-12).
#pragma once

#include <cstdint>

#include "address/type_code.h"

namespace merker::system {

struct AnyPointer {
  std::uint8_t syntax = 0x10;  // byte 0 of every ANY (S7-IND-12)
  TypeCode type = TypeCode::Void;
  std::uint32_t count = 0;
  std::uint16_t db = 0;
  std::uint32_t pointer = 0;
};

// Its bytes: type and repetition factor. 0 for types that have no size (timers, blocks).
std::uint32_t byteCount(const AnyPointer& any);

}  // namespace merker::system
