#include "interpreter/fault.h"

#include "cpu/cpu.h"
#include "interpreter/translated.h"

namespace merker::interpreter {

const Op* fail(cpu::Machine& m, const Op* op, const cpu::SyncError& error) {
  if (m.probing) {
    m.probeFailed = true;
    return op + 1;
  }
  m.position = op->offset;
  m.top->resume = indexOf(m, op + 1);
  switch (m.cpu->synchronousError(error)) {
    case cpu::AfterError::GoOn:
      return op + 1;
    case cpu::AfterError::ErrorOb:
      return codeOf(*m.top).ops.data();
    case cpu::AfterError::Stopped:
      break;
  }
  return op;
}

const Op* stop(cpu::Machine& m, const Op* op, cpu::Event why) {
  if (m.probing) {
    m.probeFailed = true;
    return op + 1;
  }
  m.position = op->offset;
  m.cpu->stopByFault(why);
  return op;
}

const Op* unknownCode(cpu::Machine& m, const Op* op) {
  return stop(m, op, cpu::Event::StopUnknownOpcode);
}
const Op* endOfCode(cpu::Machine& m, const Op* op) {
  return stop(m, op, cpu::Event::StopCodeLength);
}

}  // namespace merker::interpreter
