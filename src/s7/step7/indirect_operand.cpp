// Operands whose address is found at run time (S7-IND-03 … 06).
#include "base/text.h"
#include "step7/operand_parser.h"

namespace merker::step7 {

using mc7::OperandKind;

// [MD 10], [#pointer], ["symbol"]: the operand that holds the pointer or the number (S7-IND-03,
// -04).
bool OperandParser::memoryPointer(Width width, mc7::Operand& out) {
  const std::size_t open = cursor_.pos();
  cursor_.take();
  OperandParser inner(cursor_, scope_, problems_, localTop_);
  const auto access = inner.parse();
  cursor_.skipBlanks();
  if (!access) {
    while (!cursor_.atStatementEnd() && cursor_.peek() != ']') cursor_.take();
    cursor_.accept(']');
    return false;
  }
  if (!cursor_.accept(']')) {
    problem(ProblemCode::P0301, cursor_.pos(), "]");
    return false;
  }
  const mc7::Operand& operand = access->operand;
  const bool area = operand.area == Area::Flag || operand.area == Area::DataBlock ||
                    operand.area == Area::Instance || operand.area == Area::Local;
  if (access->kind != Access::Kind::Machine || operand.kind != OperandKind::Memory || !area ||
      access->openDb >= 0 || operand.width != width) {
    problem(width == Width::DWord ? ProblemCode::P0319 : ProblemCode::P0320, open);
    return false;
  }
  out.pointerArea = operand.area;
  out.value = operand.value / 8;
  return true;
}

std::optional<Access> OperandParser::indirect(Area area, Width width, bool crossing) {
  const std::size_t open = cursor_.pos();
  cursor_.skipBlanks();
  const std::size_t bracket = cursor_.pos();
  cursor_.take();
  cursor_.skipBlanks();
  const std::string word = upper(cursor_.word());
  if (word == "AR1" || word == "AR2") return registerIndirect(area, width, crossing, word);
  if (crossing) {
    while (!cursor_.atStatementEnd() && cursor_.peek() != ']') cursor_.take();
    cursor_.accept(']');
    return problem(ProblemCode::P0321, open);
  }
  cursor_.seek(bracket);
  mc7::Operand operand{.kind = OperandKind::MemoryIndirect, .area = area, .width = width};
  if (!memoryPointer(Width::DWord, operand)) return std::nullopt;
  return simple(operand);
}

std::optional<Access> OperandParser::registerIndirect(Area area, Width width, bool crossing,
                                                      std::string_view word) {
  const std::size_t open = cursor_.pos();
  cursor_.skipBlanks();
  cursor_.accept(',');
  cursor_.skipBlanks();
  const std::size_t begin = cursor_.pos();
  while (!cursor_.atStatementEnd() && cursor_.peek() != ']') cursor_.take();
  const auto offset =
      parseConstant(trim(cursor_.slice(begin, cursor_.pos())), at(begin, cursor_.pos()));
  if (!cursor_.accept(']')) return problem(ProblemCode::P0301, cursor_.pos(), "]");
  // S7-IND-05: P#0.0 … P#4095.7; the code has room up to P#8191.7.
  if (!offset || offset->format != ConstantFormat::Pointer || offset->bits > scope_.highestOffset())
    return problem(ProblemCode::P0322, open);
  const int reg = word == "AR1" ? 1 : 2;
  return simple(crossing ? mc7::registerCrossing(width, reg, offset->bits)
                         : mc7::registerIndirect(area, width, reg, offset->bits));
}

}  // namespace merker::step7
