#include "interpreter/compiled.h"

namespace merker::interpreter {
namespace {

// The loop has charged and counted one instruction already.
const Op* runCompiled(cpu::Machine& m, const Op* op) {
  const Translated& code = codeOf(*m.top);
  const std::uint32_t index = indexOf(m, op);
  const std::uint64_t before = m.instructions;
  m.clock.ns -= op->cost;
  const Op* const next = code.compiled->run(m, index);
  if (m.instructions != before) {
    --m.instructions;
    return next;
  }
  m.clock.ns += op->cost;
  return code.uncompiled[index](m, op);
}

}  // namespace

void attachCompiled(Translated& code) {
  if (code.compiled == nullptr || !code.uncompiled.empty()) return;
  // A call of a block with checks, or out of one, comes back to an op that is no instruction.
  if (code.side.empty()) {
    code.native = code.compiled->entries();
    code.mark = code.identity.get();
  }
  code.uncompiled.resize(code.instructionCount);
  for (std::uint32_t i = 0; i < code.instructionCount; ++i) {
    code.uncompiled[i] = code.ops[i].run;
    if (code.compiled->begins(i)) code.ops[i].run = runCompiled;
  }
}

void detachCompiled(Translated& code) {
  for (std::uint32_t i = 0; i < code.uncompiled.size(); ++i) code.ops[i].run = code.uncompiled[i];
  code.uncompiled.clear();
  code.native = nullptr;
  code.mark = nullptr;
}

void setCompiled(Translated& code, std::shared_ptr<const Compiled> compiled) {
  detachCompiled(code);
  code.compiled = std::move(compiled);
  if (code.probe == nullptr) attachCompiled(code);
}

}  // namespace merker::interpreter
