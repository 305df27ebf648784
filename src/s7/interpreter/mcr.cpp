// MCRA MCRD MCR( )MCR (S7-INSTR-129).
#include "interpreter/fault.h"
#include "interpreter/handlers.h"

namespace merker::interpreter {
namespace {

using mc7::Operation;

template <bool Active>
const Op* activate(cpu::Machine& m, const Op* op) {
  m.mcrActive = Active;
  m.updateMcr();
  return op + 1;
}

void finish(cpu::Machine& m) {
  m.updateMcr();
  m.registers.status.sta = true;
  m.registers.status.endChain();
}

// The inner zone is on only if the outer one is.
const Op* open(cpu::Machine& m, const Op* op) {
  const std::size_t base = m.levels.empty() ? 0 : m.levels.back().mcrBase;
  if (m.mcrStack.size() - base >= m.model->mcrDepth) return stop(m, op, cpu::Event::StopMcrStack);
  const bool outer = m.mcrStack.size() == base || m.mcrStack.back() != 0;
  m.mcrStack.push_back(outer && m.registers.status.rlo);
  finish(m);
  return op + 1;
}

const Op* close(cpu::Machine& m, const Op* op) {
  if (m.mcrStack.size() <= m.top->mcrDepth) return stop(m, op, cpu::Event::StopMcrStack);
  m.mcrStack.pop_back();
  finish(m);
  return op + 1;
}

}  // namespace

Rows mcrRows() {
  return {{Operation::MCRA, Form::None, activate<true>},
          {Operation::MCRD, Form::None, activate<false>},
          {Operation::MCR_OPEN, Form::None, open},
          {Operation::MCR_CLOSE, Form::None, close}};
}

}  // namespace merker::interpreter
