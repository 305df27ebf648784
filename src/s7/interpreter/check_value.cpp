#include "interpreter/check_value.h"

namespace merker::interpreter {
namespace {

using block::CheckRegister;
using block::CheckValue;

std::uint32_t registerValue(const cpu::Registers& r, CheckRegister which) {
  const cpu::StatusWord& s = r.status;
  switch (which) {
    case CheckRegister::VKE:
      return s.rlo;
    case CheckRegister::STA:
      return s.sta;
    case CheckRegister::OR:
      return s.orBit;
    case CheckRegister::OS:
      return s.os;
    case CheckRegister::OV:
      return s.ov;
    case CheckRegister::A0:
      return s.cc0;
    case CheckRegister::A1:
      return s.cc1;
    case CheckRegister::BIE:
      return s.br;
    case CheckRegister::ER:
      return s.er;
    case CheckRegister::AKKU1:
      return r.accu[0];
    case CheckRegister::AKKU2:
      return r.accu[1];
    case CheckRegister::AKKU3:
      return r.accu[2];
    case CheckRegister::AKKU4:
      return r.accu[3];
    case CheckRegister::AR1:
      return r.ar1;
    case CheckRegister::AR2:
      return r.ar2;
    case CheckRegister::STW:
      return s.word();
    case CheckRegister::DBNO:
      return r.db.number;
    case CheckRegister::DINO:
      return r.di.number;
  }
  return 0;
}

bool looksOnly(const Op& op) {
  using mc7::Operation;
  switch (op.operation) {
    case Operation::UC:
    case Operation::CC:
    case Operation::BE:
    case Operation::BEA:
    case Operation::BEB:
      return false;
    default:
      return true;
  }
}

// Runs straight through: a snippet has no jumps backwards worth following.
bool runSnippet(cpu::Machine& m, const Translated& snippet) {
  const Op* op = snippet.ops.data();
  const Op* end = op + snippet.instructionCount;
  m.probing = true;
  m.probeFailed = false;
  for (std::uint32_t i = 0; i < snippet.instructionCount && op >= snippet.ops.data() && op < end;
       ++i) {
    if (looksOnly(*op))
      op = op->run(m, op);
    else
      m.probeFailed = true;
    if (m.probeFailed) break;
  }
  m.probing = false;
  return !m.probeFailed;
}

}  // namespace

std::optional<std::uint32_t> valueOf(cpu::Machine& m, const CheckValue& value,
                                     const Translated& snippet) {
  if (value.kind == CheckValue::Kind::Constant) return value.constant;
  if (value.kind == CheckValue::Kind::Register) return registerValue(m.registers, value.reg);
  const cpu::Registers kept = m.registers;
  if (value.kind == CheckValue::Kind::BitCode) m.registers.status.endChain();  // a first check
  const bool readable = runSnippet(m, snippet);
  const std::uint32_t result =
      value.kind == CheckValue::Kind::BitCode ? m.registers.status.rlo : m.registers.accu[0];
  m.registers = kept;
  if (!readable) return std::nullopt;
  return result;
}

}  // namespace merker::interpreter
