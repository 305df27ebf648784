#include "step7/block_compiler.h"

#include <algorithm>

#include "base/text.h"
#include "step7/call_compiler.h"
#include "step7/check_comment.h"
#include "step7/mnemonic.h"

namespace merker::step7 {

using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

BlockCompiler::BlockCompiler(const BlockSource& source, block::Block& target,
                             Interfaces& interfaces, const CompileOptions& options,
                             Problems& problems)
    : source_(source),
      target_(target),
      options_(options),
      finalProblems_(problems),
      cursor_(source.file->text(), source.codeBegin, source.codeEnd) {
  scope_.file = source.file;
  scope_.mnemonics = source.mnemonics;
  scope_.options = &options;
  scope_.interfaces = &interfaces;
  scope_.block = &target;
}

void BlockCompiler::compile() {
  const std::uint32_t declared = target_.localBytes;
  // Absolute local data (LW 30) may lie behind the declared variables; what the macros need must
  // lie behind both.
  if (!pass(declared)) pass((localTop_ + 1) & ~1u);
  const std::uint32_t top = std::max({declared, localTop_, allocatedTop_});
  target_.localBytes = (top + 1) & ~1u;
  if (target_.localBytes > scope_.model().localBytes)  // S7-CPU-25
    problems_.add(ProblemCode::P0507, at(source_.name.begin, source_.name.end),
                  toString(target_.id), target_.localBytes, scope_.model().localBytes,
                  scope_.model().name);
  if (builder_->code().size() > std::min(scope_.model().blockSize, 65'534u))  // S7-LIM-03
    problems_.add(ProblemCode::P0503, at(source_.name.begin, source_.name.end),
                  toString(target_.id), builder_->code().size(), scope_.model().blockSize);
  builder_->moveInto(target_);
  finalProblems_.append(problems_);
}

// False if the transfer areas of this pass overlap local data that the program uses absolutely.
bool BlockCompiler::pass(std::uint32_t localBase) {
  problems_ = Problems();
  cursor_ = Cursor(source_.file->text(), source_.codeBegin, source_.codeEnd);
  builder_ = std::make_unique<CodeBuilder>();
  usedCopies_.clear();
  brackets_.clear();
  relays_.clear();
  ended_ = reportedAfterEnd_ = any_ = false;
  allocated_ = allocatedTop_ = localBase;
  reserveParameterCopies();
  for (;;) {
    cursor_.skipSpace();
    checks();
    if (cursor_.atEnd()) break;
    statement();
  }
  endOfBlock();
  return localTop_ <= localBase || (allocatedTop_ == localBase && usedCopies_.empty());
}

// Descriptors of composite parameters and numbers of parameter types cannot be addressed where they
// arrive; the block copies those it uses to its local data before its first statement.
void BlockCompiler::reserveParameterCopies() {
  copies_.clear();
  const bool function = target_.id.kind == BlockKind::FC;
  for (const block::Variable& variable : target_.variables) {
    const TypeCode code = variable.type->code;
    const bool composite = isComposite(code) && variable.section != block::Section::Temp &&
                           (function || variable.section == block::Section::InOut);
    const bool number = !function && isParameterNumber(code);
    if (!composite && !number) continue;
    const std::uint32_t byte = (allocated_ + 1) & ~1u;
    copies_.emplace_back(&variable, byte);
    allocated_ = byte + (composite ? 6 : 2);
  }
  copiesEnd_ = allocated_;
}

std::uint32_t BlockCompiler::parameterCopy(const block::Variable& variable) {
  if (std::find(usedCopies_.begin(), usedCopies_.end(), &variable) == usedCopies_.end())
    usedCopies_.push_back(&variable);
  allocatedTop_ = std::max(allocatedTop_, copiesEnd_);
  for (const auto& [copied, byte] : copies_)
    if (copied == &variable) return byte;
  return 0;
}

static std::uint32_t indexOf(const block::Block& block, const block::Variable& variable) {
  const auto list = block::parameters(block);
  return static_cast<std::uint32_t>(std::find(list.begin(), list.end(), &variable) - list.begin());
}

std::vector<std::uint8_t> BlockCompiler::prologue() {
  std::vector<std::uint8_t> code;
  if (usedCopies_.empty()) return code;
  const auto put = [&code](Operation operation, const Operand& operand = {}) {
    (void)mc7::encode({operation, operand}, code);
  };
  const auto localData = [](Width width, std::uint32_t byte) {
    return mc7::memory(Area::Local, width, byte * 8);
  };
  // The accumulators and AR1 stay as the caller left them.
  const std::uint32_t saved = (allocatedTop_ + 1) & ~1u;
  allocatedTop_ = saved + 12;
  put(Operation::TRANSFER, localData(Width::DWord, saved));
  put(Operation::TAK);
  put(Operation::TRANSFER, localData(Width::DWord, saved + 4));
  put(Operation::TAR1, localData(Width::DWord, saved + 8));
  for (const block::Variable* variable : usedCopies_) {
    const std::uint32_t byte = parameterCopy(*variable);
    const auto from = [&](Width width, std::uint32_t offset) {
      return mc7::registerIndirect(Area::Instance, width, 2, variable->address + offset * 8);
    };
    if (target_.id.kind == BlockKind::FC) {
      put(Operation::LOAD, mc7::number(OperandKind::ParameterAddress, indexOf(target_, *variable)));
      put(Operation::LAR1);
      put(Operation::LOAD, mc7::registerCrossing(Width::Word, 1, 0));
      put(Operation::TRANSFER, localData(Width::Word, byte));
      put(Operation::LOAD, mc7::registerCrossing(Width::DWord, 1, bitAddress(2)));
      put(Operation::TRANSFER, localData(Width::DWord, byte + 2));
      continue;
    }
    put(Operation::LOAD, from(Width::Word, 0));
    put(Operation::TRANSFER, localData(Width::Word, byte));
    if (isParameterNumber(variable->type->code)) continue;
    put(Operation::LOAD, from(Width::DWord, 2));
    put(Operation::TRANSFER, localData(Width::DWord, byte + 2));
  }
  put(Operation::LAR1, localData(Width::DWord, saved + 8));
  put(Operation::LOAD, localData(Width::DWord, saved + 4));
  put(Operation::LOAD, localData(Width::DWord, saved));
  return code;
}

std::uint32_t BlockCompiler::allocate(std::uint32_t bytes) {
  const std::uint32_t byte = bytes > 1 ? (allocated_ + 1) & ~1u : allocated_;
  allocated_ = byte + bytes;
  allocatedTop_ = std::max(allocatedTop_, allocated_);
  return byte;
}

void BlockCompiler::skipStatement() {
  while (!cursor_.atStatementEnd()) {
    const char c = cursor_.take();
    if (c != '\'' && c != '"') continue;
    while (!cursor_.atEnd() && cursor_.peek() != '\n' && cursor_.take() != c) continue;
  }
  cursor_.accept(';');
}

void BlockCompiler::checks() {
  std::vector<CheckComment> comments = std::move(cursor_.checks());
  cursor_.checks().clear();
  if (!options_.checks) return;
  for (const CheckComment& comment : comments) {
    const Position position = at(comment.begin, comment.end);
    if (!any_) {
      problems_.add(ProblemCode::P0901, position);
      continue;
    }
    Scope scope = scope_;
    scope.anyMnemonics = true;
    std::vector<const block::Variable*> used;
    auto check = parseCheckComment(comment, scope, copies_, used, problems_);
    if (!check) continue;
    for (const block::Variable* variable : used) parameterCopy(*variable);
    check->offset = builder_->lastInstruction();
    check->position = position;
    builder_->checks().push_back(std::move(*check));
  }
}

void BlockCompiler::statement() {
  if (cursor_.accept(';')) return;
  const std::size_t begin = cursor_.pos();
  const Position position = at(begin, begin + 1);
  const std::string_view word = cursor_.word();
  if (!word.empty()) {
    const std::size_t afterWord = cursor_.pos();
    cursor_.skipBlanks();
    if (cursor_.peek() == ':' && cursor_.peek(1) != '=') {
      cursor_.take();
      labelDefinition(word, begin);
      cursor_.skipSpace();
      checks();
      if (!cursor_.atEnd()) statement();
      return;
    }
    cursor_.seek(afterWord);
    if (networkHeader(word)) return;
  }
  cursor_.seek(begin);
  const std::string name = readMnemonic(cursor_);
  if (ended_ && !reportedAfterEnd_) {
    problems_.add(ProblemCode::P0331, position);
    reportedAfterEnd_ = true;
  }
  allocated_ = copiesEnd_;
  builder_->line(position.line, position.column);
  instruction(name, begin);
  checks();
}

void BlockCompiler::labelDefinition(std::string_view word, std::size_t begin) {
  const Position position = at(begin, begin + word.size());
  if (characterCount(word) > 4) problems_.add(ProblemCode::P0332, position, std::string(word));
  if (!brackets_.empty())
    problems_.add(ProblemCode::P0333, position, std::string(word));  // S7-BRACKET-03
  builder_->label(std::string(word), position, problems_);           // labels keep their case
}

bool BlockCompiler::networkHeader(std::string_view word) {
  if (equalsIgnoreCase(word, "NETWORK")) {
    endOfNetwork();
    builder_->network({});
    cursor_.accept(';');
    return true;
  }
  if (!equalsIgnoreCase(word, "TITLE")) return false;
  const std::size_t saved = cursor_.pos();
  if (!cursor_.accept('=')) {
    cursor_.seek(saved);
    return false;
  }
  const std::size_t begin = cursor_.pos();
  cursor_.skipLine();
  builder_->networkTitle(std::string(trim(cursor_.slice(begin, cursor_.pos()))));
  return true;
}

void BlockCompiler::instruction(const std::string& name, std::size_t begin) {
  if (name == "CALL") {
    CallCompiler call(*this);
    if (call.compile(begin))
      endOfStatement();
    else
      skipStatement();
    any_ = true;
    ended_ = false;
    return;
  }
  const auto operation = mc7::findOperation(name, scope_.mnemonics);
  if (!operation) {
    const Mnemonics other =
        scope_.mnemonics == Mnemonics::German ? Mnemonics::International : Mnemonics::German;
    const bool foreign = mc7::findOperation(name, other).has_value();
    problems_.add(!foreign                                ? ProblemCode::P0334
                  : scope_.mnemonics == Mnemonics::German ? ProblemCode::P0314
                                                          : ProblemCode::P0315,
                  at(begin, cursor_.pos()), name);
    skipStatement();
    return;
  }
  const std::size_t before = problems_.size();
  if (isJump(*operation))
    jump(*operation, begin);
  else
    operate(*operation, begin, name);
  any_ = true;
  const bool bracket = *operation >= Operation::AND_OPEN && *operation <= Operation::XOR_NOT_OPEN;
  if (problems_.size() != before)
    skipStatement();
  else if (bracket)
    cursor_.accept(';');  // U( O E 0.0 may stand on one line
  else
    endOfStatement();
}

void BlockCompiler::endOfStatement() {
  if (cursor_.accept(';')) return;
  if (cursor_.atLineEnd()) return;
  problems_.add(ProblemCode::P0302, here(), std::string(1, cursor_.peek()));
  skipStatement();
}

void BlockCompiler::jump(Operation operation, std::size_t begin) {
  ended_ = false;
  cursor_.skipBlanks();
  const std::size_t labelBegin = cursor_.pos();
  const std::string label(cursor_.word());
  if (label.empty()) {
    problems_.add(ProblemCode::P0335, at(begin, cursor_.pos()));
    return;
  }
  if (operation == Operation::SPL)
    builder_->jumpList(label, at(labelBegin, cursor_.pos()));
  else
    builder_->jump(operation, label, at(labelBegin, cursor_.pos()));
}

std::optional<Access> BlockCompiler::operand() {
  OperandParser parser(cursor_, scope_, problems_, localTop_);
  parser.setParameterCopies(&copies_);
  auto access = parser.parse();
  if (access && access->variable && access->operand.pointerArea == Area::Local &&
      isParameterNumber(access->variable->type->code))
    parameterCopy(*access->variable);
  return access;
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

// Which way data flow: PE is read, PA written; IN parameters of a function are read only
// (S7-OPND-09, S7-FC-06).
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
      access.kind == Access::Kind::Machine || access.kind == Access::Kind::Descriptor;
  if (accessesValue && access.type && !isElementary(access.type->code) &&
      !isParameterNumber(access.type->code)) {
    problems_.add(ProblemCode::P0326, place, block::toString(*access.type), name);  // S7-TYPES-17
    return false;
  }
  if (!access.variable || !accessesValue) return true;
  const bool function = target_.id.kind == BlockKind::FC;
  const bool timerOrCounter = access.type && isParameterNumber(access.type->code);
  if (writes && !timerOrCounter && access.variable->section == block::Section::Input) {
    problems_.add(function ? ProblemCode::P0325 : ProblemCode::P0340, place, access.variable->name);
    return !function;
  }
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
    const std::uint32_t byte = parameterCopy(*access.descriptor);
    Operand open{.kind = OperandKind::BlockIndirect,
                 .pointerArea = Area::Local,
                 .blockKind = BlockKind::DB,
                 .value = byte};
    if (!emit(Operation::OPEN, open)) return false;
    if (!emit(Operation::LAR1, mc7::memory(Area::Local, Width::DWord, (byte + 2) * 8)))
      return false;
    Operand operand = access.operand;
    for (; operand.value > 0x7FFF; operand.value -= 0x7FF8)
      if (!emit(Operation::ADD_AR1, mc7::number(OperandKind::Pointer, 0x7FF8))) return false;
    return emit(operation, operand) || impossible();
  }
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
  if (!callee || (!own && (id.kind == BlockKind::FC || id.kind == BlockKind::FB))) {
    problems_.add(ProblemCode::P0508, place, toString(id));
    return;
  }
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
  if (!emit(operation, operand)) {
    problems_.add(ProblemCode::P0311, at(access.begin, access.end),
                  std::string(cursor_.slice(access.begin, access.end)), mc7::info(operation).de);
    return;
  }
  const bool list = operand.blockKind == BlockKind::FC || operand.blockKind == BlockKind::SFC;
  if (list) (void)emit(Operation::SPA, mc7::number(OperandKind::Jump, 2));
}

void BlockCompiler::endOfNetwork() {
  for (const std::size_t open : brackets_)
    problems_.add(ProblemCode::P0344, at(open, open + 1));  // S7-BRACKET-01, -02
  brackets_.clear();
}

void BlockCompiler::endOfBlock() {
  endOfNetwork();
  for (const std::size_t open : relays_) problems_.add(ProblemCode::P0345, at(open, open + 1));
  if (!ended_) (void)emit(Operation::BE);
  builder_->resolveJumps(problems_);
  const std::vector<std::uint8_t> code = prologue();
  if (!code.empty()) builder_->prepend(code);
}

}  // namespace merker::step7
