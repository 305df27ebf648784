#include "interpreter/probing.h"

#include "interpreter/compiled.h"

namespace merker::interpreter {
namespace {

const Op* runProbed(cpu::Machine& m, const Op* op) {
  const Translated& code = codeOf(*m.top);
  m.top->resume = indexOf(m, op);  // where HALT would stand
  if (code.probe->before(m, op->offset)) {
    m.clock.ns -= op->cost;  // charged already, and counted when the loop ends
    --m.instructions;
    m.interrupt();
    return op;
  }
  const std::size_t depth = m.frames.size();
  const Op* next = code.unprobed[indexOf(m, op)](m, op);
  if (m.frames.size() <= depth) code.probe->after(m, code, op->offset);
  return next;
}

}  // namespace

void setProbe(Translated& code, cpu::Probe* probe) {
  code.probe = probe;
  const bool probed = !code.unprobed.empty();
  if ((probe != nullptr) == probed) return;
  if (!probed) detachCompiled(code);
  if (!probed) code.unprobed.resize(code.instructionCount);
  for (std::uint32_t i = 0; i < code.instructionCount; ++i) {
    if (!probed) code.unprobed[i] = code.ops[i].run;
    code.ops[i].run = probed ? code.unprobed[i] : runProbed;
  }
  if (!probed) return;
  code.unprobed.clear();
  attachCompiled(code);
}

}  // namespace merker::interpreter
