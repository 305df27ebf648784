#include "compilation/existence.h"

#include <fmt/format.h>

#include <algorithm>

#include "mc7/disassembly.h"
#include "mc7/instruction.h"
#include "scenario/long_value.h"

namespace merker::compilation {
namespace {

bool inDataBlock(const address::Reference& reference) {
  return reference.operand.kind == address::OperandKind::Memory &&
         reference.operand.area == Area::DataBlock;
}

const block::Block* dataBlock(const address::Reference& reference, const block::Program& program) {
  const auto found = program.find({BlockKind::DB, static_cast<std::uint16_t>(reference.db)});
  return found == program.end() ? nullptr : &found->second;
}

// S7-SFC-10: CREAT_DB.
bool callsCreate(const mc7::Line& line) {
  if (line.kind != mc7::LineKind::Instruction) return false;
  const auto decoded = mc7::decode(line.bytes);
  if (!decoded) return false;
  const mc7::Operand& operand = decoded->instruction.operand;
  return operand.kind == mc7::OperandKind::Block && operand.blockKind == BlockKind::SFC &&
         operand.value == 22;
}

bool callsCreate(const block::Block& block) {
  const auto lines = mc7::disassemble(block.code, Mnemonics::German);
  return std::any_of(lines.begin(), lines.end(),
                     [](const mc7::Line& line) { return callsCreate(line); });
}

}  // namespace

bool exists(const address::Reference& reference, const controller::Controller& plc) {
  return simulator::isLong(reference) ? plc.readBytes(reference).has_value()
                                      : plc.read(reference).has_value();
}

std::optional<Problem> Existence::problem(const address::Reference& reference,
                                          const Position& at) const {
  if (exists(reference, station_)) return std::nullopt;
  const bool mayCome = inDataBlock(reference) && !dataBlock(reference, station_.program());
  if (mayCome && makesDataBlocks()) return std::nullopt;
  return makeProblem(ProblemCode::P0962, at, reference.text, station_.whyMissing(reference));
}

bool Existence::makesDataBlocks() const {
  const block::Program& program = station_.program();
  return std::any_of(program.begin(), program.end(),
                     [](const auto& entry) { return callsCreate(entry.second); });
}

}  // namespace merker::compilation
