// Jumps (9.4.11). The instruction at a label begins a new chain (S5-JUMP-07).
#include "softplc/handlers.h"

namespace merker::sinumerik {
namespace {

using mc5::Instruction;
using mc5::Operation;

bool jumpWhen(Processor& p, const Instruction& i, bool condition) {
  p.displays().orBit = p.displays().chain = false;
  if (condition) p.jump(static_cast<std::int32_t>(i.operand.value));
  return condition;
}

bool always(Processor& p, const Instruction& i) { return jumpWhen(p, i, true); }

bool ifVke(Processor& p, const Instruction& i) {
  const bool taken = jumpWhen(p, i, p.vke());
  p.displays().vke = true;  // also when it was not taken (S5-JUMP-01)
  return taken;
}

bool ifZero(Processor& p, const Instruction& i) {
  return jumpWhen(p, i, !p.displays().anz1 && !p.displays().anz0);
}
bool ifNotZero(Processor& p, const Instruction& i) {
  return jumpWhen(p, i, p.displays().anz1 != p.displays().anz0);
}
bool ifPlus(Processor& p, const Instruction& i) {
  return jumpWhen(p, i, p.displays().anz1 && !p.displays().anz0);
}
bool ifMinus(Processor& p, const Instruction& i) {
  return jumpWhen(p, i, !p.displays().anz1 && p.displays().anz0);
}
bool ifOverflow(Processor& p, const Instruction& i) { return jumpWhen(p, i, p.displays().ov); }

bool ifStored(Processor& p, const Instruction& i) {
  const bool stored = p.displays().os;
  p.displays().os = false;  // OP-24
  return jumpWhen(p, i, stored);
}

constexpr HandlerRow kJumpRows[] = {{Operation::JUMP, always},
                                    {Operation::JUMP_IF, ifVke},
                                    {Operation::JUMP_ZERO, ifZero},
                                    {Operation::JUMP_NOT_ZERO, ifNotZero},
                                    {Operation::JUMP_PLUS, ifPlus},
                                    {Operation::JUMP_MINUS, ifMinus},
                                    {Operation::JUMP_OVERFLOW, ifOverflow},
                                    {Operation::JUMP_STORED, ifStored}};

}  // namespace

HandlerRows jumpHandlers() { return kJumpRows; }

}  // namespace merker::sinumerik
