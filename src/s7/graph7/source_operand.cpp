#include "graph7/source_operand.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "graph/missing.h"
#include "graph7/operand_code.h"
#include "graph7/operand_kind.h"
#include "step7/mnemonic.h"

namespace merker::graph7 {
namespace {

using graph::OperandKind;

// As the machine code has them (access.h): a number that an instance holds is reached through a
// word of local data, which only timers and counters have a picture for.
OperandKind kindOfAccess(const step7::Access& access) {
  const mc7::Operand& operand = access.operand;
  switch (access.kind) {
    case step7::Access::Kind::Number:
      return operand.kind == mc7::OperandKind::BlockIndirect ? OperandKind::Forbidden
                                                             : OperandKind::Number;
    case step7::Access::Kind::Descriptor:
      return operand.width == Width::Bit ? OperandKind::Bit : OperandKind::Value;
    case step7::Access::Kind::Machine:
    case step7::Access::Kind::Address:
    case step7::Access::Kind::BlockName:
      break;
  }
  return kindOf(operand);
}

// Two texts with the same code mean the same operand: "Motor" and A 4.0. What stands before the
// machine operand: how it is reached, the data block that is opened, the parameter it belongs to.
std::string codeOf(step7::Access::Kind kind, std::int32_t db, std::string_view name,
                   const mc7::Operand& operand) {
  std::vector<std::uint8_t> before{
      static_cast<std::uint8_t>(kind), static_cast<std::uint8_t>((db + 1) >> 16),
      static_cast<std::uint8_t>((db + 1) >> 8), static_cast<std::uint8_t>(db + 1)};
  before.insert(before.end(), name.begin(), name.end());
  return pack(before, operand);
}

std::string codeOf(const step7::Access& access) {
  const bool byName =
      access.kind == step7::Access::Kind::Number || access.kind == step7::Access::Kind::Descriptor;
  return codeOf(access.kind, access.openDb,
                byName && access.variable ? upper(access.variable->name) : std::string(),
                access.operand);
}

// The text up to the end of the statement; texts and names in quotation marks are passed whole.
std::string_view rest(step7::Cursor& cursor) {
  const std::size_t begin = cursor.pos();
  while (!cursor.atStatementEnd()) {
    const char c = cursor.take();
    if (c != '\'' && c != '"') continue;
    while (!cursor.atEnd() && cursor.peek() != '\n' && cursor.take() != c) continue;
  }
  return trim(cursor.slice(begin, cursor.pos()));
}

// Whatever it is, it may stand where its operation does.
graph::Operand unresolved(std::string_view text) {
  if (text.starts_with(graph::kMissingBegin)) return graph::missing(text);
  graph::Operand operand;
  if (text.empty()) return operand;
  operand.kind = OperandKind::Number;
  operand.code = normalized(text);
  operand.text = text;
  return operand;
}

}  // namespace

BitAddress behindLocal(const graph::Operand& operand) {
  if (operand.kind == OperandKind::Wire) return operand.number + 1;
  const mc7::Operand machine = unpack(operand.code).operand;
  const bool local = machine.kind == mc7::OperandKind::Memory && machine.area == Area::Local;
  return local ? machine.value + byteCount(machine.width) * 8 : 0;
}

bool isStatusWord(const graph::Operand& operand) {
  return unpack(operand.code).operand.kind == mc7::OperandKind::StatusWord;
}

std::optional<std::uint32_t> dataBlockOf(const graph::Statement& statement) {
  const mc7::Operand operand = unpack(statement.operand.code).operand;
  const bool opens = statement.op == graph::Op::OPEN && operand.kind == mc7::OperandKind::Block &&
                     operand.blockKind == BlockKind::DB && operand.reg == 0;
  return opens ? std::optional(operand.value) : std::nullopt;
}

bool openDataBlock(graph::Operand& operand, std::uint32_t db) {
  const mc7::Operand machine = unpack(operand.code).operand;
  if (machine.kind != mc7::OperandKind::Memory || machine.area != Area::DataBlock) return false;
  const auto number = static_cast<std::int32_t>(db);
  const std::string code = codeOf(step7::Access::Kind::Machine, -1, {}, machine);
  if (operand.code != code) return false;  // it opens one itself
  operand.code = codeOf(step7::Access::Kind::Machine, number, {}, machine);
  operand.text = fmt::format("DB{}.{}", db, operand.text);
  return true;
}

std::string normalized(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (c != ' ' && c != '\t' && c != '\r' && c != '\n') out += c;
  return upper(out);
}

BitAddress behindTemps(const block::Block& block) {
  BitAddress end = 0;
  for (const block::Variable& v : block.variables)
    if (v.section == block::Section::Temp)
      end = std::max(end, v.address + block::sizeInBits(*v.type));
  return end;
}

SourceOperands::SourceOperands(const source::SourceFile& file, const block::Block& block,
                               Mnemonics mnemonics, step7::Interfaces& interfaces,
                               const step7::CompileOptions& options)
    : wires_(behindTemps(block)) {
  scope_.file = &file;
  scope_.mnemonics = mnemonics;
  scope_.anyMnemonics = true;
  scope_.options = &options;
  scope_.interfaces = &interfaces;
  scope_.block = &block;
  scope_.names = &interfaces.names(block);
}

bool SourceOperands::isWire(const mc7::Operand& operand) const {
  return operand.kind == mc7::OperandKind::Memory && operand.area == Area::Local &&
         operand.width == Width::Bit && operand.value >= wires_;
}

std::optional<step7::Access> SourceOperands::parse(step7::Cursor& cursor) const {
  Problems problems;
  std::uint32_t localTop = 0;
  return step7::OperandParser(cursor, scope_, problems, localTop).parse();
}

graph::Operand SourceOperands::read(step7::Cursor& cursor, mc7::Operation operation) const {
  cursor.skipBlanks();
  const std::size_t begin = cursor.pos();
  const auto access = parse(cursor);
  if (access && cursor.atStatementEnd()) {
    graph::Operand operand = resolved(*access, operation);
    operand.text = trim(cursor.slice(begin, access->end));
    return operand;
  }
  cursor.seek(begin);
  return unresolved(rest(cursor));
}

graph::Operand SourceOperands::resolved(const step7::Access& access,
                                        mc7::Operation operation) const {
  mc7::Operand machine = access.operand;
  Problems ignored;
  if (machine.kind == mc7::OperandKind::Constant)
    machine = step7::fittedConstant(operation, machine, {}, ignored);
  graph::Operand operand;
  operand.kind = machine.kind == access.operand.kind ? kindOfAccess(access) : kindOf(machine);
  operand.number = machine.value;
  const bool wire = operand.kind == OperandKind::Bit && access.openDb < 0 && isWire(machine);
  if (wire) operand.kind = OperandKind::Wire;
  const bool byNumber =
      wire || operand.kind == OperandKind::Status || operand.kind == OperandKind::Count;
  if (!byNumber) operand.code = codeOf(access);
  return operand;
}

std::optional<graph::Operand> SourceOperands::of(std::string_view text) const {
  const source::SourceFile file("", std::string(text));
  SourceOperands here = *this;
  here.scope_.file = &file;
  step7::Cursor cursor(file.text(), 0, file.text().size());
  graph::Operand operand = here.read(cursor, mc7::Operation::LOAD);
  return cursor.atEnd() ? std::optional(std::move(operand)) : std::nullopt;
}

std::optional<step7::Access> SourceOperands::alone(std::string_view text) const {
  const source::SourceFile file("", std::string(text));
  SourceOperands here = *this;
  here.scope_.file = &file;
  step7::Cursor cursor(file.text(), 0, file.text().size());
  auto access = here.parse(cursor);
  cursor.skipBlanks();
  return cursor.atEnd() ? std::move(access) : std::nullopt;
}

}  // namespace merker::graph7
