#include "interpreter/side.h"

#include "cpu/cpu.h"
#include "interpreter/recorder.h"

namespace merker::interpreter {

const Op* runWithSide(cpu::Machine& m, const Op* op) {
  const Translated& code = codeOf(*m.top);
  const std::uint32_t index = indexOf(m, op);
  const Side& side = code.side[index];
  if (!code.executed.empty()) ++code.executed[index];
  const std::size_t depth = m.frames.size();
  const Op* next = side.original(m, op);
  if (side.checks == 0 || m.cpu->state().stoppedByFault()) return next;
  if (m.frames.size() > depth)  // a call or an error OB: look when it has returned
    m.frames[depth - 1].resume = side.afterCall;
  else
    code.recorder->evaluate(m, side.firstCheck, side.checks,
                            m.frames.size() < depth || next != op + 1);
  return next;
}

const Op* runAfterCall(cpu::Machine& m, const Op* op) {
  const Translated& code = codeOf(*m.top);
  const Side& side = code.side[op->value];
  code.recorder->evaluate(m, side.firstCheck, side.checks, false);
  --m.instructions;  // this op is no instruction
  return code.ops.data() + op->value + 1;
}

}  // namespace merker::interpreter
