// UC CC BE BEA BEB (S7-INSTR-106 … -110) and calls of system blocks.
#include "cpu/cpu.h"
#include "interpreter/fault.h"
#include "interpreter/handlers.h"
#include "interpreter/operand_access.h"
#include "interpreter/translated.h"

namespace merker::interpreter {
namespace {

using cpu::ErrorCode;
using cpu::SyncError;
using mc7::Operation;

struct KindRow {
  BlockKind kind;
  ErrorCode number, missing;
};
constexpr KindRow kKinds[] = {{BlockKind::FC, ErrorCode::FcNumber, ErrorCode::FcMissing},
                              {BlockKind::FB, ErrorCode::FbNumber, ErrorCode::FbMissing},
                              {BlockKind::SFC, ErrorCode::SfcMissing, ErrorCode::SfcMissing},
                              {BlockKind::SFB, ErrorCode::SfbMissing, ErrorCode::SfbMissing}};

const KindRow& rowOf(BlockKind kind) {
  for (const KindRow& row : kKinds)
    if (row.kind == kind) return row;
  return kKinds[0];
}

std::int64_t highest(const CpuModel& model, BlockKind kind) {
  if (kind == BlockKind::FC) return model.highestFc;
  return kind == BlockKind::FB ? model.highestFb : UINT16_MAX;
}

// OS 0, OR 0, STA 1, /ER 0.
void finish(cpu::StatusWord& s) {
  s.os = false;
  s.sta = true;
  s.endChain();
}

// SFC, SFB, and library FCs that no block of the program hides.
const Op* callSystem(cpu::Machine& m, const Op* op, std::uint32_t number) {
  const Translated& code = codeOf(*m.top);
  m.position = op->offset;
  m.top->resume = indexOf(m, op) + 1;
  const std::span<const std::uint32_t> list(code.parameters.data() + op->target, op->count);
  const BlockId id{op->blockKind, static_cast<std::uint16_t>(number)};
  const bool known = m.cpu->callSystem(id, list);
  finish(m.registers.status);
  if (const SyncError error = m.cpu->takeSystemError()) return fail(m, op, error);
  if (known) return op + 1;
  return fail(m, op, {.code = rowOf(op->blockKind).missing, .detail = number});
}

const Op* enter(cpu::Machine& m, const Op* op, const cpu::Code* block) {
  m.position = op->offset;
  m.top->resume = indexOf(m, op) + 1;
  const std::uint32_t* list = codeOf(*m.top).parameters.data() + op->target;
  if (!m.enter(block)) return op;
  m.top->parameters = list;
  m.top->parameterCount = op->count;
  finish(m.registers.status);
  return codeOf(*m.top).ops.data();
}

const Op* call(cpu::Machine& m, const Op* op) {
  std::uint32_t number = 0;
  if (const SyncError error = numberOperand(m, op, number)) {
    finish(m.registers.status);
    return fail(m, op, error);
  }
  const auto& table = op->blockKind == BlockKind::FB ? m.functionBlocks : m.functions;
  const bool loadable = op->blockKind == BlockKind::FC || op->blockKind == BlockKind::FB;
  if (loadable)
    if (const cpu::Code* block = cpu::find(table, number)) return enter(m, op, block);
  if (number <= highest(*m.model, op->blockKind)) return callSystem(m, op, number);
  finish(m.registers.status);
  return fail(m, op, {.code = rowOf(op->blockKind).number, .detail = number});
}

// CC: afterwards VKE is 1, called or not.
const Op* callIf(cpu::Machine& m, const Op* op) {
  cpu::StatusWord& s = m.registers.status;
  if (s.rlo) return call(m, op);
  finish(s);
  s.rlo = true;
  return op + 1;
}

const Op* end(cpu::Machine& m, const Op* op) {
  finish(m.registers.status);
  if (m.top->first) {
    m.levelEnded = true;
    m.interrupt();
    return op;
  }
  m.leave();
  return codeOf(*m.top).ops.data() + m.top->resume;
}

const Op* endIf(cpu::Machine& m, const Op* op) {
  cpu::StatusWord& s = m.registers.status;
  if (s.rlo) return end(m, op);
  s.rlo = s.sta = true;
  s.endChain();
  return op + 1;
}

}  // namespace

Rows callRows() {
  return {{Operation::UC, Form::Other, call},
          {Operation::CC, Form::Other, callIf},
          {Operation::BE, Form::None, end},
          {Operation::BEA, Form::None, end},
          {Operation::BEB, Form::None, endIf}};
}

}  // namespace merker::interpreter
