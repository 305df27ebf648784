// Operands of a PLC as clients name them, and their values.
#pragma once

#include <cstdint>

#include "s7comm/pdu.h"

namespace merker::s7comm {

enum class Memory : std::uint8_t {
  Counter = 0x1C,
  Timer = 0x1D,
  Peripheral = 0x80,  // read: PE, written: PA
  Input = 0x81,
  Output = 0x82,
  Flag = 0x83,
  DataBlock = 0x84
};

// Bytes one behind the other, or timers and counters of two bytes each, as LC loads them.
struct Range {
  Memory memory = Memory::Flag;
  std::uint16_t block = 0;   // number of the data block
  std::uint32_t begin = 0;   // byte, or number of the timer or counter
  std::uint32_t octets = 0;  // of the value
  std::uint8_t bit = 0;
  bool oneBit = false;  // the value is one octet, 0 or 1
  bool operator==(const Range&) const = default;
};

constexpr bool isCell(Memory memory) {
  return memory == Memory::Timer || memory == Memory::Counter;
}

struct Value {
  ItemCode code = ItemCode::Done;
  Bytes octets{};  // as many as the range has; none unless it is done
  bool operator==(const Value&) const = default;
};

}  // namespace merker::s7comm
