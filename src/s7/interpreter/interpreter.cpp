#include "interpreter/interpreter.h"

#include <algorithm>

#include "interpreter/probing.h"
#include "interpreter/side.h"

namespace merker::interpreter {
namespace {

constexpr std::uint32_t kStartInformation = 20;  // S7-OBI-01: every OB has it

// The instruction that a check belongs to: at its offset, or the last one before.
std::int32_t opOf(const OpByWord& opAt, std::uint32_t offset) {
  for (std::size_t word = std::min<std::size_t>(offset / 2 + 1, opAt.size()); word-- > 0;)
    if (opAt[word] >= 0) return opAt[word];
  return -1;
}

}  // namespace

std::unique_ptr<cpu::Code> Interpreter::translate(const block::Block& block) {
  auto code = std::make_unique<Translated>();
  code->source = &block;
  const OpByWord opAt = translator_.translate(block.code, *code);
  code->localBytes = std::max(block.localBytes, localUse(*code));
  code->looks = looksOf(*code);
  if (block.id.kind == BlockKind::OB)
    code->localBytes = std::max(code->localBytes, kStartInformation);
  code->localBytes = (code->localBytes + 1) / 2 * 2;
  if (coverage_ || !block.checks.empty()) attachSide(block, *code, opAt);
  return code;
}

void Interpreter::attachSide(const block::Block& block, Translated& code, const OpByWord& opAt) {
  const std::uint32_t count = code.instructionCount;
  code.side.resize(count);
  code.recorder = &recorder_;
  if (coverage_) {
    code.executed.resize(count);
    counted_.push_back(&code);
  }

  std::map<std::int32_t, std::vector<const block::Check*>> byOp;
  for (const block::Check& check : block.checks) {
    const std::int32_t op = opOf(opAt, check.offset);
    if (op >= 0 && static_cast<std::uint32_t>(op) < count)
      byOp[op].push_back(&check);
    else
      recorder_.add(check, translator_);  // belongs to nothing: never reached
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto found = byOp.find(static_cast<std::int32_t>(i));
    if (found == byOp.end() && !coverage_) continue;
    Side& side = code.side[i];
    side.original = code.ops[i].run;
    code.ops[i].run = runWithSide;
    if (found == byOp.end()) continue;
    for (const block::Check* check : found->second) {
      const std::uint32_t number = recorder_.add(*check, translator_);
      if (side.checks++ == 0) side.firstCheck = number;
    }
    side.afterCall = static_cast<std::uint32_t>(code.ops.size());
    Op after;
    after.run = runAfterCall;
    after.value = i;
    after.offset = code.ops[i].offset;
    code.ops.push_back(after);
  }
}

void Interpreter::run(cpu::Machine& m) {
  const Op* op = codeOf(*m.top).ops.data() + m.top->resume;
  std::uint64_t count = 0;
  do {
    m.clock.ns += op->cost;
    ++count;
    op = op->run(m, op);
  } while (m.clock < m.horizon);
  m.instructions += count;
  if (!m.levelEnded) m.top->resume = indexOf(m, op);
}

void Interpreter::probe(cpu::Code& code, cpu::Probe* probe) {
  auto& translated = static_cast<Translated&>(code);
  probes_ += static_cast<int>(probe != nullptr) - static_cast<int>(translated.probe != nullptr);
  setProbe(translated, probe);
}

std::map<BlockId, std::map<std::uint32_t, std::uint64_t>> Interpreter::executed() const {
  std::map<BlockId, std::map<std::uint32_t, std::uint64_t>> result;
  for (const Translated* code : counted_) {
    auto& block = result[code->source->id];
    for (std::uint32_t i = 0; i < code->instructionCount; ++i)
      if (code->executed[i] != 0) block[code->ops[i].offset] = code->executed[i];
  }
  return result;
}

std::uint32_t Interpreter::offset(const cpu::Frame& frame) const {
  return frame.code == nullptr ? 0 : codeOf(frame).ops[frame.resume].offset;
}

}  // namespace merker::interpreter
