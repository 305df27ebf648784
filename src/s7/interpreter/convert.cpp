// BTI BTD ITB DTB ITD DTR (S7-INSTR-92 … -97).
#include <bit>
#include <cstdlib>

#include "base/bcd.h"
#include "interpreter/arithmetic.h"
#include "interpreter/fault.h"
#include "interpreter/handlers.h"

namespace merker::interpreter {
namespace {

using mc7::Operation;

constexpr cpu::SyncError kBcdError{.code = cpu::ErrorCode::Bcd};

// Sign in the highest bit, 3 or 7 digits. A wrong digit leaves AKKU1 as it is.
const Op* bcdToInt(cpu::Machine& m, const Op* op) {
  const std::uint32_t bcd = m.registers.low(0);
  const auto value = fromBcd(bcd & 0xFFF, 3);
  if (!value) return fail(m, op, kBcdError);
  m.registers.setLow((bcd & 0x8000) != 0 ? 0 - *value : *value);
  return op + 1;
}

const Op* bcdToDint(cpu::Machine& m, const Op* op) {
  const std::uint32_t bcd = m.registers.accu[0];
  const auto value = fromBcd(bcd & 0x0FFF'FFFF, 7);
  if (!value) return fail(m, op, kBcdError);
  m.registers.accu[0] = (bcd & 0x8000'0000u) != 0 ? 0 - *value : *value;
  return op + 1;
}

// Beyond ±999 or ±9999999: unchanged, OV and OS.
const Op* intToBcd(cpu::Machine& m, const Op* op) {
  const int value = static_cast<std::int16_t>(m.registers.low(0));
  const bool overflow = std::abs(value) > 999;
  setOverflow(m.registers.status, overflow);
  if (!overflow)
    m.registers.setLow((value < 0 ? 0xF000u : 0u) |
                       toBcd(static_cast<std::uint32_t>(std::abs(value)), 3));
  return op + 1;
}

const Op* dintToBcd(cpu::Machine& m, const Op* op) {
  const std::int64_t value = static_cast<std::int32_t>(m.registers.accu[0]);
  const bool overflow = std::abs(value) > 9'999'999;
  setOverflow(m.registers.status, overflow);
  if (!overflow)
    m.registers.accu[0] =
        (value < 0 ? 0xF000'0000u : 0u) | toBcd(static_cast<std::uint32_t>(std::abs(value)), 7);
  return op + 1;
}

const Op* intToDint(cpu::Machine& m, const Op* op) {
  m.registers.accu[0] = static_cast<std::uint32_t>(static_cast<std::int16_t>(m.registers.low(0)));
  return op + 1;
}

const Op* dintToReal(cpu::Machine& m, const Op* op) {
  const auto value = static_cast<float>(static_cast<std::int32_t>(m.registers.accu[0]));
  m.registers.accu[0] = std::bit_cast<std::uint32_t>(value);
  return op + 1;
}

}  // namespace

Rows convertRows() {
  return {{Operation::BTI, Form::None, bcdToInt},  {Operation::BTD, Form::None, bcdToDint},
          {Operation::ITB, Form::None, intToBcd},  {Operation::DTB, Form::None, dintToBcd},
          {Operation::ITD, Form::None, intToDint}, {Operation::DTR, Form::None, dintToReal}};
}

}  // namespace merker::interpreter
