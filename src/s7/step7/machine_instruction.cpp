#include "step7/machine_instruction.h"

#include <algorithm>
#include <charconv>

#include "base/text.h"
#include "step7/declaration.h"
#include "step7/mnemonic.h"
#include "step7/operand_parser.h"

namespace merker::step7 {
namespace {

using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

// All of the text; false if it is not a hexadecimal number.
bool readHex(std::string_view text, std::uint32_t& out) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out, 16);
  return error == std::errc() && end == text.data() + text.size();
}

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

// "ANY#16#1002": W#16# with the code that STEP 7 gives the first word of an ANY.
std::optional<Operand> anyHeaderOperand(Cursor& cursor) {
  constexpr std::string_view kPrefix = "ANY#16#";
  const std::size_t start = cursor.pos();
  const std::string_view rest = cursor.slice(start, std::min(start + 11, cursor.end()));
  std::uint32_t bits = 0;
  if (rest.size() < 11 || !equalsIgnoreCase(rest.substr(0, kPrefix.size()), kPrefix) ||
      !readHex(rest.substr(kPrefix.size()), bits))
    return std::nullopt;
  cursor.seek(start + rest.size());
  return mc7::anyHeader(bits);
}

// One line of text on its way to an instruction. Positions of problems are those in the line.
class LineParser {
 public:
  LineParser(const source::SourceFile& line, std::optional<Mnemonics> setting, Mnemonics mnemonics)
      : mnemonics_(mnemonics), cursor_(line.text(), 0, line.text().size()) {
    options_.model = findCpuModel("generic-4");
    scope_.file = &line;
    scope_.mnemonics = mnemonics;
    scope_.anyMnemonics = !setting;
    scope_.limits = Limits::OfCode;
    scope_.options = &options_;
  }

  Result<mc7::Instruction> parse() {
    cursor_.skipSpace();
    const std::size_t begin = cursor_.pos();
    const std::string name = readMnemonic(cursor_);
    const auto operation = mc7::findOperation(name, mnemonics_);
    if (!operation) return unknown(name, begin);
    word_ = cursor_.slice(begin, cursor_.pos());
    mc7::Instruction instruction{*operation, {}};
    cursor_.skipBlanks();
    operandBegin_ = cursor_.pos();
    if (!cursor_.atStatementEnd()) {
      auto operand = this->operand(*operation);
      if (!operand) return operand.error();
      instruction.operand = *operand;
    } else if (*operation == Operation::OR) {
      instruction.operation = Operation::AND_BEFORE_OR;
    }
    return checked(status(instruction));
  }

 private:
  Position at(std::size_t begin, std::size_t end) const {
    return scope_.file->position(begin, std::max(end, begin + 1) - begin);
  }

  Problem unknown(const std::string& name, std::size_t begin) const {
    const Mnemonics other =
        mnemonics_ == Mnemonics::German ? Mnemonics::International : Mnemonics::German;
    const bool foreign = !scope_.anyMnemonics && mc7::findOperation(name, other);
    return makeProblem(!foreign                          ? ProblemCode::P0334
                       : mnemonics_ == Mnemonics::German ? ProblemCode::P0314
                                                         : ProblemCode::P0315,
                       at(begin, cursor_.pos()), name);
  }

  static mc7::Instruction status(mc7::Instruction instruction) {
    if (instruction.operand.kind == OperandKind::StatusWord)
      instruction.operation =
          instruction.operation == Operation::LOAD ? Operation::LOAD_STW : Operation::TRANSFER_STW;
    return instruction;
  }

  Result<Operand> distance(Operation operation) {
    const auto words = readInteger(cursor_);
    const bool list = operation == Operation::SPL;
    const std::int64_t low = list ? 0 : -32768, high = list ? 65535 : 32767;
    if (!words) {
      while (!cursor_.atStatementEnd()) cursor_.take();
      return makeProblem(ProblemCode::P0346, at(operandBegin_, cursor_.pos()));
    }
    if (*words < low || *words > high)
      return makeProblem(ProblemCode::P0352, at(operandBegin_, cursor_.pos()), *words, word_, low,
                         high);
    return mc7::number(list ? OperandKind::JumpList : OperandKind::Jump,
                       static_cast<std::uint32_t>(*words));
  }

  Result<Operand> operand(Operation operation) {
    if (isJump(operation)) return distance(operation);
    if (const auto formal = formalOperand(cursor_)) return *formal;
    if (const auto header = anyHeaderOperand(cursor_)) return *header;
    Problems problems;
    std::uint32_t localTop = 0;
    const auto access = OperandParser(cursor_, scope_, problems, localTop).parse();
    if (!access) return problems.list().front();
    const Position place = at(access->begin, access->end);
    if (access->openDb >= 0) return makeProblem(ProblemCode::P0318, place);  // two instructions
    Operand result = access->operand;
    if (result.kind == OperandKind::Constant)
      result = fittedConstant(operation, result, place, problems, Limits::OfCode);
    if (problems.hasErrors()) return problems.list().front();
    return result;
  }

  // Nothing follows, and there is a code for it.
  Result<mc7::Instruction> checked(const mc7::Instruction& instruction) {
    const std::size_t end = cursor_.pos();
    cursor_.accept(';');
    if (!cursor_.atLineEnd())
      return makeProblem(ProblemCode::P0302, at(cursor_.pos(), cursor_.pos()),
                         std::string(1, cursor_.peek()));
    std::vector<std::uint8_t> code;
    if (mc7::encode(instruction, code)) return instruction;
    if (end == operandBegin_) return makeProblem(ProblemCode::P0316, at(end, end));
    return makeProblem(ProblemCode::P0311, at(operandBegin_, end),
                       std::string(trim(cursor_.slice(operandBegin_, end))), word_);
  }

  CompileOptions options_;
  Scope scope_;
  Mnemonics mnemonics_;
  Cursor cursor_;
  std::string_view word_;  // the mnemonic as written
  std::size_t operandBegin_ = 0;
};

}  // namespace

std::optional<Result<std::uint32_t>> parseMachineEntry(std::string_view text, const Position& at) {
  const bool number = !text.empty() && isDigit(text.front());
  const bool bits = equalsIgnoreCase(text.substr(0, 3), "DW#");
  if (!number && !bits && !equalsIgnoreCase(text.substr(0, 2), "P#")) return std::nullopt;
  const auto constant = parseConstant(text, at);
  if (!constant) return constant.error();
  if (!number) return constant->bits;
  if (constant->bits > 0xFFFF) return makeProblem(ProblemCode::P0202, at, text, "0..65535");
  return constant->bits << 16;  // of a timer, counter or block: in the first word
}

Result<mc7::Instruction> parseMachineInstruction(std::string_view text, const Position& at,
                                                 std::optional<Mnemonics> setting) {
  const source::SourceFile line(at.file, std::string(text));
  auto result = LineParser(line, setting, setting.value_or(Mnemonics::German)).parse();
  if (!result && !setting) {
    auto other = LineParser(line, setting, Mnemonics::International).parse();
    if (other || result.error().code == ProblemCode::P0334) result = std::move(other);
  }
  if (result) return result;
  Problem problem = result.error();
  problem.position.line = at.line;
  problem.position.column += at.column - 1;
  return problem;
}

}  // namespace merker::step7
