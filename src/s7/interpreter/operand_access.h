// Operands whose place is only known when the instruction runs (S7-IND-03 … -07, S7-PAR-01), and
// the quick way to the others.
#pragma once

#include "cpu/memory_access.h"
#include "interpreter/form.h"
#include "interpreter/op.h"

namespace merker::interpreter {

// Area and bit address that the operand names now.
struct Effective {
  Area area = Area::None;
  BitAddress address = 0;
  cpu::SyncError error{};
};
Effective effective(cpu::Machine& m, const Op* op, cpu::Access access);

cpu::SyncError readOperand(cpu::Machine& m, const Op* op, Width width, std::uint32_t& value);
cpu::SyncError writeOperand(cpu::Machine& m, const Op* op, Width width, std::uint32_t value);
cpu::Located locateOperand(cpu::Machine& m, const Op* op, Width width, cpu::Access access);

// Number of a timer, counter or block: direct, in a word of memory, or handed over as parameter.
cpu::SyncError numberOperand(cpu::Machine& m, const Op* op, std::uint32_t& number);

// Direct operands: the byte, or null if it lies outside (no block open, block too short).
template <Form F>
inline std::uint8_t* readable(cpu::Machine& m, const Op* op, std::uint32_t bytes) {
  const std::uint32_t byte = op->value >> 3;
  if constexpr (F == Form::Image) return m.image + op->value;
  if constexpr (F == Form::Data)
    return byte + bytes <= m.registers.db.length ? m.registers.db.data + byte : nullptr;
  if constexpr (F == Form::Instance)
    return byte + bytes <= m.registers.di.length ? m.registers.di.data + byte : nullptr;
  if constexpr (F == Form::Local)
    return byte + bytes <= m.top->localLength ? m.top->local + byte : nullptr;
  return nullptr;
}

template <Form F>
inline std::uint8_t* writable(cpu::Machine& m, const Op* op, std::uint32_t bytes) {
  const std::uint32_t byte = op->value >> 3;
  if constexpr (F == Form::Data)
    return byte + bytes <= m.registers.db.writable ? m.registers.db.data + byte : nullptr;
  if constexpr (F == Form::Instance)
    return byte + bytes <= m.registers.di.writable ? m.registers.di.data + byte : nullptr;
  return readable<F>(m, op, bytes);
}

}  // namespace merker::interpreter
