// = S R with a bit in memory (S7-INSTR-20 … -22) under the master control relay (S7-INSTR-129).
#include "interpreter/fault.h"
#include "interpreter/handlers.h"
#include "interpreter/operand_access.h"

namespace merker::interpreter {
namespace {

// What to write, if anything; STA := the RLO, for = the value written (S7-OPEN-50).
struct Assign {
  static bool writes(const cpu::Machine&) { return true; }
  static bool value(const cpu::Machine& m) { return m.registers.status.rlo && !m.mcrOff; }
  static bool state(const cpu::Machine& m) { return value(m); }
};
struct Set {
  static bool writes(const cpu::Machine& m) { return m.registers.status.rlo && !m.mcrOff; }
  static bool value(const cpu::Machine&) { return true; }
  static bool state(const cpu::Machine& m) { return m.registers.status.rlo; }
};
struct Reset {
  static bool writes(const cpu::Machine& m) { return Set::writes(m); }
  static bool value(const cpu::Machine&) { return false; }
  static bool state(const cpu::Machine& m) { return m.registers.status.rlo; }
};

template <typename Output>
void finish(cpu::Machine& m) {
  m.registers.status.sta = Output::state(m);
  m.registers.status.endChain();
}

template <typename Output>
const Op* anywhere(cpu::Machine& m, const Op* op) {
  cpu::SyncError error;
  if (Output::writes(m)) error = writeOperand(m, op, Width::Bit, Output::value(m));
  finish<Output>(m);
  return goOn(m, op, error);
}

template <typename Output, Form F>
const Op* direct(cpu::Machine& m, const Op* op) {
  if (Output::writes(m)) {
    std::uint8_t* byte = writable<F>(m, op, 1);
    if (byte == nullptr) [[unlikely]]
      return anywhere<Output>(m, op);
    *byte = static_cast<std::uint8_t>(Output::value(m) ? *byte | op->mask : *byte & ~op->mask);
  }
  finish<Output>(m);
  return op + 1;
}

template <typename Output>
void add(Rows& rows, mc7::Operation operation) {
  rows.insert(rows.end(), {{operation, Form::Image, direct<Output, Form::Image>},
                           {operation, Form::Data, direct<Output, Form::Data>},
                           {operation, Form::Instance, direct<Output, Form::Instance>},
                           {operation, Form::Local, direct<Output, Form::Local>},
                           {operation, Form::Memory, anywhere<Output>}});
}

}  // namespace

Rows bitOutputRows() {
  Rows rows;
  add<Assign>(rows, mc7::Operation::ASSIGN);
  add<Set>(rows, mc7::Operation::SET_BIT);
  add<Reset>(rows, mc7::Operation::RESET_BIT);
  return rows;
}

}  // namespace merker::interpreter
