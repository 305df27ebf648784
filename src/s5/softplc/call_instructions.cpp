// Block calls, block ends, opening of data blocks, stops, no-operations (9.3.6, 9.3.9).
#include "base/bcd.h"
#include "softplc/handlers.h"

namespace merker::sinumerik {
namespace {

using mc5::BlockId;
using mc5::Instruction;
using mc5::Operation;

BlockId blockOf(const Instruction& i) {
  return {i.operand.block, static_cast<std::uint16_t>(i.operand.value)};
}

void leaveChain(Displays& d) { d.orBit = d.chain = false; }

bool call(Processor& p, const Instruction& i) { return p.call(blockOf(i)); }

// A condition that is not met leaves VKE = 1 (S5-BLK-16, OP-50).
bool notTaken(Processor& p) {
  leaveChain(p.displays());
  p.displays().vke = true;
  return false;
}

bool callIf(Processor& p, const Instruction& i) {
  return p.vke() ? p.call(blockOf(i)) : notTaken(p);
}

bool end(Processor& p, const Instruction&) {
  p.leave();
  return true;
}

bool endIf(Processor& p, const Instruction&) {
  if (!p.vke()) return notTaken(p);
  p.leave();
  return true;
}

bool open(Processor& p, const Instruction& i) {
  Machine& m = p.machine();
  const BlockId id = blockOf(i);
  const Entry& entry = m.blocks.find(id);
  const auto number = static_cast<std::uint16_t>(toBcd(id.number, 4));
  if (!entry.present) return p.fail(Alarm::MissingDb, p.opcode(), 0, number);
  m.frame().data = {true, id.number, entry.start, entry.length};
  return true;
}

bool nothing(Processor&, const Instruction&) { return true; }

bool stp(Processor& p, const Instruction&) {
  p.requestStop();
  return true;
}

bool sts(Processor& p, const Instruction&) { return p.fail(Alarm::Sts, p.opcode()); }

constexpr HandlerRow kCallRows[] = {
    {Operation::CALL, call},    {Operation::CALL_IF, callIf}, {Operation::END, end},
    {Operation::END_IF, endIf}, {Operation::END_ALWAYS, end}, {Operation::OPEN, open},
    {Operation::NOP0, nothing}, {Operation::NOP1, nothing},   {Operation::BLD, nothing},
    {Operation::STP, stp},      {Operation::STS, sts}};

}  // namespace

HandlerRows callHandlers() { return kCallRows; }

}  // namespace merker::sinumerik
