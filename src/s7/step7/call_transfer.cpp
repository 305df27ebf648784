// One value between the caller and the instance of a called function block. The data block
// registers are exchanged then: the instance is in DI, what was in DI is in DB (code patterns,
// section 3).
#include "step7/call_compiler.h"
#include "step7/parameter_access.h"

namespace merker::step7 {

using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

CallCompiler::Way CallCompiler::wayTo(const Access& access) {
  const Operand& operand = access.operand;
  if (access.kind == Access::Kind::Descriptor) return Way::Pointed;
  if (access.openDb >= 0 || operand.area == Area::DataBlock) return Way::OtherBlock;
  if (operand.kind == OperandKind::Parameter) return Way::Entry;
  return operand.area == Area::Instance ? Way::OwnData : Way::Direct;
}

// AUF DI n, AUF DI [LW n]: the data block of the actual parameter takes the place of the instance.
Operand CallCompiler::otherBlock(const Access& access) const {
  if (access.openDb < 0) return blockInWord(openNumber_.value / 8, true);
  return mc7::blockOperand(BlockKind::DB, static_cast<std::uint32_t>(access.openDb), true);
}

namespace {

// The operand with another area, to be used as it stands.
Access inArea(const Access& access, Area area) {
  Access result;
  result.operand = access.operand;
  result.operand.area = area;
  return result;
}

}  // namespace

void CallCompiler::valueIn(const Access& from, const Operand& to) {
  switch (wayTo(from)) {
    case Way::Direct:
      read(from);
      break;
    case Way::OwnData:
      read(inArea(from, Area::DataBlock));
      break;
    case Way::OtherBlock:
      put(Operation::OPEN, otherBlock(from));
      read(inArea(from, Area::Instance));
      openInstance();
      break;
    case Way::Pointed:
      pointedIn(from);
      break;
    case Way::Entry:
      read(machine(copiesOfEntries_.at(from.variable)));
      break;
  }
  write(machine(to));
}

void CallCompiler::valueOut(const Operand& from, const Access& to) {
  const Way way = wayTo(to);
  if (way != Way::Pointed) read(machine(from));
  switch (way) {
    case Way::Direct:
      write(to);
      break;
    case Way::OwnData:
      write(inArea(to, Area::DataBlock));
      break;
    case Way::OtherBlock:
      put(Operation::OPEN, otherBlock(to));
      write(inArea(to, Area::Instance));
      openInstance();
      break;
    case Way::Pointed:
      pointedOut(from, to);
      break;
    case Way::Entry:
      afterwards_.push_back({newPlace(from.width), to});
      write(machine(afterwards_.back().from));
      break;
  }
}

void CallCompiler::pointedIn(const Access& from) {
  const Operand number = newPlace(Width::Word);
  (void)c_.emitAll(followPointer(c_.scope(), {.parameter = *from.descriptor,
                                              .word = number.value / 8,
                                              .own = Area::DataBlock,
                                              .asInstance = true}));
  put(Operation::SWAP_DB);
  read(machine(from.operand));
  put(Operation::SWAP_DB);
  openInstance();
}

// The value is read while the instance is open.
void CallCompiler::pointedOut(const Operand& from, const Access& to) {
  const Operand number = newPlace(Width::Word);
  (void)c_.emitAll(followPointer(c_.scope(), {.parameter = *to.descriptor,
                                              .word = number.value / 8,
                                              .own = Area::DataBlock,
                                              .opens = false}));
  read(machine(from));
  put(Operation::OPEN, blockInWord(number.value / 8, true));
  put(Operation::SWAP_DB);
  write(machine(to.operand));
  put(Operation::SWAP_DB);
  openInstance();
}

}  // namespace merker::step7
