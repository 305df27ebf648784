// Jumps inside a block (S7-INSTR-112 … -128). Taken or not, they cost the same.
#include "interpreter/handlers.h"

namespace merker::interpreter {
namespace {

using mc7::Operation;

const Op* jump(const Op* op, bool taken) { return taken ? op + op->target : op + 1; }

const Op* always(cpu::Machine&, const Op* op) { return op + op->target; }

// SPB, SPBN, SPBB, SPBNB (S7-INSTR-113 … -116): afterwards VKE is 1 and a new chain begins.
template <bool Wanted, bool SaveToBr>
const Op* onRlo(cpu::Machine& m, const Op* op) {
  cpu::StatusWord& s = m.registers.status;
  const bool taken = s.rlo == Wanted;
  if constexpr (SaveToBr) s.br = s.rlo;
  s.rlo = s.sta = true;
  s.endChain();
  return jump(op, taken);
}

// SPBI, SPBIN (S7-INSTR-117)
template <bool Wanted>
const Op* onBr(cpu::Machine& m, const Op* op) {
  cpu::StatusWord& s = m.registers.status;
  s.sta = true;
  s.endChain();
  return jump(op, s.br == Wanted);
}

const Op* onOverflow(cpu::Machine& m, const Op* op) { return jump(op, m.registers.status.ov); }

// SPS takes the bit back (S7-INSTR-119).
const Op* onStoredOverflow(cpu::Machine& m, const Op* op) {
  const bool taken = m.registers.status.os;
  m.registers.status.os = false;
  return jump(op, taken);
}

// A1 A0 as a number 0 … 3; Set has the bit of each combination that jumps (S7-INSTR-120 … -126).
template <unsigned Set>
const Op* onConditions(cpu::Machine& m, const Op* op) {
  const unsigned conditions = m.registers.status.cc1 * 2u + m.registers.status.cc0;
  return jump(op, (Set >> conditions & 1) != 0);
}
constexpr unsigned kZero = 1u << 0b00, kMinus = 1u << 0b01, kPlus = 1u << 0b10,
                   kUnordered = 1u << 0b11;

// SPL (S7-INSTR-127): the list behind it are SPA instructions; target is what follows the list.
const Op* distribute(cpu::Machine& m, const Op* op) {
  const std::uint32_t entry = m.registers.accu[0] & 0xFF;
  return entry < op->count ? op + 1 + entry : op + op->target;
}

// LOOP (S7-INSTR-128)
const Op* loop(cpu::Machine& m, const Op* op) {
  m.registers.setLow(m.registers.accu[0] - 1);
  return jump(op, m.registers.low(0) != 0);
}

}  // namespace

Rows jumpRows() {
  return {{Operation::SPA, Form::Other, always},
          {Operation::SPB, Form::Other, onRlo<true, false>},
          {Operation::SPBN, Form::Other, onRlo<false, false>},
          {Operation::SPBB, Form::Other, onRlo<true, true>},
          {Operation::SPBNB, Form::Other, onRlo<false, true>},
          {Operation::SPBI, Form::Other, onBr<true>},
          {Operation::SPBIN, Form::Other, onBr<false>},
          {Operation::SPO, Form::Other, onOverflow},
          {Operation::SPS, Form::Other, onStoredOverflow},
          {Operation::SPU, Form::Other, onConditions<kUnordered>},
          {Operation::SPZ, Form::Other, onConditions<kZero>},
          {Operation::SPP, Form::Other, onConditions<kPlus>},
          {Operation::SPM, Form::Other, onConditions<kMinus>},
          {Operation::SPN, Form::Other, onConditions<kPlus | kMinus>},
          {Operation::SPMZ, Form::Other, onConditions<kZero | kMinus>},
          {Operation::SPPZ, Form::Other, onConditions<kZero | kPlus>},
          {Operation::SPL, Form::Other, distribute},
          {Operation::LOOP, Form::Other, loop}};
}

}  // namespace merker::interpreter
