// FP and FN (S7-INSTR-18, -19).
#include "interpreter/fault.h"
#include "interpreter/handlers.h"
#include "interpreter/operand_access.h"

namespace merker::interpreter {
namespace {

template <bool Rising>
const Op* edge(cpu::Machine& m, const Op* op) {
  cpu::StatusWord& s = m.registers.status;
  const cpu::Located place = locateOperand(m, op, Width::Bit, cpu::Access::Write);
  const bool before = place.bytes != nullptr && (*place.bytes & place.mask) != 0;
  const bool now = s.rlo;
  if (place.bytes != nullptr)
    *place.bytes =
        static_cast<std::uint8_t>(now ? *place.bytes | place.mask : *place.bytes & ~place.mask);
  s.rlo = Rising ? now && !before : !now && before;
  s.sta = now;
  s.orBit = false;
  s.er = true;
  return goOn(m, op, place.error);
}

// E, A, M inside their limits need no search.
template <bool Rising>
const Op* edgeInImage(cpu::Machine& m, const Op* op) {
  cpu::StatusWord& s = m.registers.status;
  std::uint8_t& byte = m.image[op->value];
  const bool before = (byte & op->mask) != 0, now = s.rlo;
  byte = static_cast<std::uint8_t>(now ? byte | op->mask : byte & ~op->mask);
  s.rlo = Rising ? now && !before : !now && before;
  s.sta = now;
  s.orBit = false;
  s.er = true;
  return op + 1;
}

}  // namespace

Rows edgeRows() {
  using mc7::Operation;
  Rows rows{{Operation::EDGE_POSITIVE, Form::Image, edgeInImage<true>},
            {Operation::EDGE_NEGATIVE, Form::Image, edgeInImage<false>}};
  for (const Form form : {Form::Data, Form::Instance, Form::Local, Form::Memory}) {
    rows.push_back({Operation::EDGE_POSITIVE, form, edge<true>});
    rows.push_back({Operation::EDGE_NEGATIVE, form, edge<false>});
  }
  return rows;
}

}  // namespace merker::interpreter
