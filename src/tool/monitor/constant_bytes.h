// What the instructions of a CALL lay down as constants in local data and in the instance: POINTER
// and ANY of composite parameters, numbers of timers, counters and blocks (S7-IND-11 … 15).
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "address/type_code.h"
#include "mc7/instruction.h"

namespace merker::monitor {

struct Descriptor {
  TypeCode type = TypeCode::Void;  // of an ANY
  std::uint32_t count = 0;
  std::uint16_t db = 0;
  std::uint32_t pointer = 0;
};

class ConstantBytes {
 public:
  void clear() { *this = {}; }
  void executed(const mc7::Instruction& instruction);

  // Parts of the instance count from the beginning of the block that is called.
  std::optional<std::uint32_t> value(Area area, BitAddress at, Width width) const;
  std::optional<Descriptor> pointer(Area area, BitAddress at) const;
  std::optional<Descriptor> any(Area area, BitAddress at) const;

 private:
  using Bytes = std::map<std::uint32_t, std::uint8_t>;
  void load(const mc7::Operand& operand);
  void transfer(const mc7::Operand& operand);

  Bytes local_, instance_;
  std::optional<std::uint32_t> accu_;
  std::uint32_t shift_ = 0;  // bytes: where a multiple instance begins in the own one
};

}  // namespace merker::monitor
