#include "step7/machine_instruction.h"

#include "base/text.h"
#include "step7/declaration.h"
#include "step7/mnemonic.h"
#include "step7/operand_parser.h"

namespace merker::step7 {
namespace {

using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

// #P0, B #P1, T #P2, FC #P3, DI #P4, P##P5
std::optional<Operand> formalOperand(Cursor& cursor) {
  const std::size_t start = cursor.pos();
  const std::string word = upper(cursor.word());
  cursor.skipBlanks();
  const bool address = word == "P" && cursor.peek() == '#' && cursor.peek(1) == '#';
  if (address) cursor.take();
  if (cursor.peek() == '#' && (cursor.peek(1) == 'P' || cursor.peek(1) == 'p')) {
    cursor.seek(cursor.pos() + 2);
    if (const auto index = readInteger(cursor); index && *index >= 0) {
      Operand operand{.kind = address ? OperandKind::ParameterAddress : OperandKind::Parameter,
                      .value = static_cast<std::uint32_t>(*index)};
      operand.width = word == "B"   ? Width::Byte
                      : word == "W" ? Width::Word
                      : word == "D" ? Width::DWord
                                    : Width::Bit;
      if (word == "T") operand.kind = OperandKind::TimerParameter;
      if (word == "Z" || word == "C") operand.kind = OperandKind::CounterParameter;
      const auto kind = word == "DI" ? std::optional(BlockKind::DB) : blockKindFromName(word);
      if (kind) {
        operand.kind = OperandKind::BlockParameter;
        operand.blockKind = *kind;
        operand.reg = word == "DI" ? 1 : 0;
      }
      return operand;
    }
  }
  cursor.seek(start);
  return std::nullopt;
}

Result<mc7::Instruction> withOperand(Cursor& cursor, Operation operation, const Scope& scope,
                                     const Position& at) {
  Problems problems;
  std::uint32_t localTop = 0;
  Operand operand;
  if (isJump(operation)) {
    const auto distance = readInteger(cursor);
    if (!distance) return makeProblem(ProblemCode::P0346, at);
    operand = mc7::number(operation == Operation::SPL ? OperandKind::JumpList : OperandKind::Jump,
                          static_cast<std::uint32_t>(*distance));
  } else if (const auto formal = formalOperand(cursor)) {
    operand = *formal;
  } else {
    const auto access = OperandParser(cursor, scope, problems, localTop).parse();
    if (!access) {
      Problem problem = problems.list().front();
      problem.position = at;
      return problem;
    }
    operand = access->operand;
    if (access->openDb >= 0) return makeProblem(ProblemCode::P0318, at);  // two instructions
    if (operand.kind == OperandKind::Constant)
      operand = fittedConstant(operation, operand, at, problems, Limits::OfCode);
    if (problems.hasErrors()) return problems.list().front();
  }
  if (operand.kind == OperandKind::StatusWord)
    operation = operation == Operation::LOAD ? Operation::LOAD_STW : Operation::TRANSFER_STW;
  return mc7::Instruction{operation, operand};
}

Result<mc7::Instruction> parseWith(std::string_view text, const Position& at, Mnemonics mnemonics) {
  const source::SourceFile file(at.file, std::string(text));
  static constexpr std::string_view kModel = "generic-4";
  CompileOptions options;
  options.model = findCpuModel(kModel);
  Scope scope;
  scope.file = &file;
  scope.anyMnemonics = true;
  scope.limits = Limits::OfCode;
  scope.options = &options;
  Cursor cursor(file.text(), 0, file.text().size());
  cursor.skipSpace();
  const std::string name = readMnemonic(cursor);
  auto operation = mc7::findOperation(name, mnemonics);
  if (!operation) return makeProblem(ProblemCode::P0334, at, name);
  if (cursor.atStatementEnd()) {
    if (*operation == Operation::OR) operation = Operation::AND_BEFORE_OR;
    return mc7::Instruction{*operation, {}};
  }
  auto result = withOperand(cursor, *operation, scope, at);
  cursor.accept(';');
  if (result && !cursor.atLineEnd())
    return makeProblem(ProblemCode::P0302, at, std::string(1, cursor.peek()));
  return result;
}

}  // namespace

Result<mc7::Instruction> parseMachineInstruction(std::string_view text, const Position& at) {
  auto german = parseWith(text, at, Mnemonics::German);
  std::vector<std::uint8_t> code;
  if (german && mc7::encode(*german, code)) return german;
  auto international = parseWith(text, at, Mnemonics::International);
  if (international && mc7::encode(*international, code)) return international;
  if (!german) return german;
  return makeProblem(ProblemCode::P0311, at, std::string(trim(text)), "an instruction");
}

}  // namespace merker::step7
