// One operation with its operand: what is allowed, and the machine code that does it.
#include "step7/block_compiler.h"
#include "step7/mnemonic.h"

namespace merker::step7 {

using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

std::optional<Access> BlockCompiler::operand() {
  return OperandParser(cursor_, scope_, problems_, localTop_).parse();
}

bool BlockCompiler::emit(Operation operation, const Operand& operand) {
  return builder_->emit(operation, operand);
}

void BlockCompiler::structure(Operation operation, std::size_t begin) {
  const bool opens = operation >= Operation::AND_OPEN && operation <= Operation::XOR_NOT_OPEN;
  if (opens) {
    brackets_.push_back(begin);
    if (brackets_.size() == scope_.model().bracketDepth + 1)  // S7-BRACKET-04
      problems_.add(ProblemCode::P0336, at(begin, cursor_.pos()), scope_.model().bracketDepth,
                    scope_.model().name);
  } else if (operation == Operation::CLOSE) {
    if (brackets_.empty())
      problems_.add(ProblemCode::P0337, at(begin, cursor_.pos()));
    else
      brackets_.pop_back();
  } else if (operation == Operation::MCR_OPEN) {
    relays_.push_back(begin);
    if (relays_.size() == scope_.model().mcrDepth + 1)
      problems_.add(ProblemCode::P0338, at(begin, cursor_.pos()), scope_.model().mcrDepth,
                    scope_.model().name);
  } else if (operation == Operation::MCR_CLOSE && !relays_.empty()) {
    relays_.pop_back();
  }
  if ((operation == Operation::ENT || operation == Operation::LEAVE) &&
      scope_.model().accumulators < 4)
    problems_.add(ProblemCode::P0339, at(begin, cursor_.pos()), mc7::info(operation).de,
                  scope_.model().name);
}

// The variables of an FB are reached through DI and AR2 (S7-IND-10).
void BlockCompiler::checkInstanceRegisters(Operation operation, const Access* access,
                                           std::size_t begin) {
  if (target_.id.kind != BlockKind::FB || target_.instanceBytes == 0) return;
  // What comes back from a variable is the restoring itself.
  if (access && (access->operand.kind == OperandKind::Memory ||
                 access->operand.kind == OperandKind::BlockIndirect))
    return;
  const bool opensInstance = operation == Operation::OPEN && access && access->operand.reg == 1;
  if (opensInstance || operation == Operation::LAR2 || operation == Operation::ADD_AR2 ||
      operation == Operation::TAR || operation == Operation::SWAP_DB)
    problems_.add(ProblemCode::P0347, at(begin, cursor_.pos()),
                  opensInstance || operation == Operation::SWAP_DB ? "DI" : "AR2");
}

void BlockCompiler::operate(Operation operation, std::size_t begin, const std::string& name) {
  structure(operation, begin);
  ended_ = operation == Operation::BE;
  if (!worksWithoutOperand(operation)) {
    cursor_.skipSpace();  // the operand may stand on the next line
  } else if (cursor_.atStatementEnd()) {
    if (operation == Operation::OR) operation = Operation::AND_BEFORE_OR;
    checkInstanceRegisters(operation, nullptr, begin);
    if (!emit(operation)) problems_.add(ProblemCode::P0316, at(begin, cursor_.pos()));
    return;
  } else if (operation >= Operation::AND_OPEN && operation <= Operation::AND_BEFORE_OR) {
    return (void)emit(operation);
  }
  auto operandAccess = operand();
  if (!operandAccess) return;
  Access& access = *operandAccess;
  checkInstanceRegisters(operation, &access, begin);
  if (operation == Operation::LOAD && access.operand.kind == OperandKind::StatusWord)
    operation = Operation::LOAD_STW;
  if (operation == Operation::TRANSFER && access.operand.kind == OperandKind::StatusWord)
    operation = Operation::TRANSFER_STW;
  if (!checkDirection(operation, access, name)) return;
  if (operation == Operation::UC || operation == Operation::CC) return blockCall(operation, access);
  if (operation >= Operation::LAR1 && operation <= Operation::TAR2)
    return addressRegister(operation, access);
  if (access.operand.kind == OperandKind::Constant)
    access.operand =
        fittedConstant(operation, access.operand, at(access.begin, access.end), problems_);
  this->access(operation, access);
}

// Which way data flow: PE is read, PA written (S7-OPND-09). IN parameters should only be read, OUT
// parameters of a function only written (S7-FC-06).
bool BlockCompiler::checkDirection(Operation operation, const Access& access,
                                   const std::string& name) {
  const Position place = at(access.begin, access.end);
  const bool writes = operation == Operation::TRANSFER || operation == Operation::ASSIGN ||
                      operation == Operation::SET_BIT || operation == Operation::RESET_BIT ||
                      operation == Operation::EDGE_POSITIVE ||
                      operation == Operation::EDGE_NEGATIVE;
  if (access.operand.area == Area::Peripheral && access.operand.kind != OperandKind::Constant &&
      writes != access.peripheralOutput) {
    problems_.add(writes ? ProblemCode::P0323 : ProblemCode::P0324, place);
    return false;
  }
  const bool accessesValue =
      access.kind != Access::Kind::Address && access.kind != Access::Kind::BlockName;
  if (accessesValue && access.type && !isElementary(access.type->code) &&
      !isParameterNumber(access.type->code)) {
    problems_.add(ProblemCode::P0326, place, block::toString(*access.type), name);  // S7-TYPES-17
    return false;
  }
  if (!access.variable || !accessesValue) return true;
  const bool function = target_.id.kind == BlockKind::FC;
  const bool timerOrCounter = access.type && isParameterNumber(access.type->code);
  if (writes && !timerOrCounter && access.variable->section == block::Section::Input)
    problems_.add(function ? ProblemCode::P0325 : ProblemCode::P0340, place, access.variable->name);
  const bool reads = !writes && operation != Operation::OPEN;
  if (reads && function && (access.variable->section == block::Section::Output))
    problems_.add(ProblemCode::P0341, place, access.variable->name);
  return true;
}

bool BlockCompiler::access(Operation operation, const Access& access) {
  const auto impossible = [&] {
    problems_.add(
        ProblemCode::P0311, at(access.begin, access.end),
        std::string(cursor_.slice(access.begin, access.end)),
        scope_.mnemonics == Mnemonics::German ? mc7::info(operation).de : mc7::info(operation).en);
    return false;
  };
  if (access.kind == Access::Kind::Descriptor) {
    followParameter(access);
    Operand operand = access.operand;
    for (; operand.value > 0x7FFF; operand.value -= 0x7FF8)
      if (!emit(Operation::ADD_AR1, mc7::number(OperandKind::Pointer, 0x7FF8))) return false;
    return emit(operation, operand) || impossible();
  }
  if (access.kind == Access::Kind::Number)
    return emit(operation, numberParameter(access)) || impossible();
  const bool blockName = access.kind == Access::Kind::BlockName;
  const bool takesBlock = operation == Operation::OPEN;
  if (blockName && (!takesBlock || access.operand.blockKind != BlockKind::DB)) return impossible();
  if (access.openDb >= 0) {
    std::vector<std::uint8_t> probe;
    if (!mc7::encode({operation, access.operand}, probe)) return impossible();
    if (!emit(Operation::OPEN,
              mc7::blockOperand(BlockKind::DB, static_cast<std::uint32_t>(access.openDb))))
      return false;
  }
  return emit(operation, access.operand) || impossible();
}

// LAR1 P##parameter and variables that no LAR/TAR instruction reaches: by way of accumulator 1,
// which is kept.
void BlockCompiler::addressRegister(Operation operation, const Access& access) {
  const bool load = operation == Operation::LAR1 || operation == Operation::LAR2;
  std::vector<std::uint8_t> probe;
  if (access.kind == Access::Kind::Machine && access.openDb < 0 &&
      mc7::encode({operation, access.operand}, probe))
    return (void)emit(operation, access.operand);
  if (access.kind == Access::Kind::Address && mc7::encode({operation, access.operand}, probe))
    return (void)emit(operation, access.operand);
  const bool wide = access.operand.width == Width::DWord || access.kind == Access::Kind::Address;
  if (!wide || (access.kind == Access::Kind::Machine && !access.variable && access.openDb < 0)) {
    problems_.add(ProblemCode::P0311, at(access.begin, access.end),
                  std::string(cursor_.slice(access.begin, access.end)), mc7::info(operation).de);
    return;
  }
  if (load) {
    if (this->access(Operation::LOAD, access) && emit(operation)) (void)emit(Operation::POP);
  } else {
    if (emit(operation) && this->access(Operation::TRANSFER, access)) (void)emit(Operation::POP);
  }
}

void BlockCompiler::checkCallWithoutParameters(Operation operation, const Access& access) {
  const BlockId id{access.operand.blockKind, static_cast<std::uint16_t>(access.operand.value)};
  const std::string_view name = mc7::info(operation).de;
  const Position place = at(access.begin, access.end);
  const block::Block* callee = scope_.findBlock(id);
  const bool own = scope_.interfaces->program().count(id) != 0;
  const bool system = id.kind == BlockKind::SFC || id.kind == BlockKind::SFB;
  const block::Program* library = scope_.options->library;
  const bool executed = own || (system && library != nullptr && library->contains(id));
  if (!callee || !executed) {
    problems_.add(ProblemCode::P0508, place, toString(id));
    return;
  }
  // STEP 7 compiles it (code patterns, section 8).
  if (!block::parameters(*callee).empty())
    problems_.add(ProblemCode::P0509, place, name, toString(id));  // S7-FC-02, S7-FC-03, S7-FB-02
}

void BlockCompiler::blockCall(Operation operation, const Access& access) {
  const Operand& operand = access.operand;
  const bool block = operand.kind == OperandKind::Block ||
                     operand.kind == OperandKind::BlockIndirect ||
                     operand.kind == OperandKind::BlockParameter;
  const bool callable = operand.blockKind == BlockKind::FC || operand.blockKind == BlockKind::FB ||
                        operand.blockKind == BlockKind::SFC || operand.blockKind == BlockKind::SFB;
  if (!block || !callable) {
    problems_.add(
        operand.blockKind == BlockKind::OB && block ? ProblemCode::P0510 : ProblemCode::P0311,
        at(access.begin, access.end), std::string(cursor_.slice(access.begin, access.end)),
        mc7::info(operation).de);
    return;
  }
  if (operand.kind == OperandKind::Block) checkCallWithoutParameters(operation, access);
  if (!emit(operation, access.kind == Access::Kind::Number ? numberParameter(access) : operand)) {
    problems_.add(ProblemCode::P0311, at(access.begin, access.end),
                  std::string(cursor_.slice(access.begin, access.end)), mc7::info(operation).de);
    return;
  }
  const bool list = operand.blockKind == BlockKind::FC || operand.blockKind == BlockKind::SFC;
  if (list) (void)emit(Operation::SPA, mc7::number(OperandKind::Jump, 2));
}

}  // namespace merker::step7
