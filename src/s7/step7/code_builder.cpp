#include "step7/code_builder.h"

#include "base/bytes.h"
#include "mc7/disassembly.h"

namespace merker::step7 {

bool CodeBuilder::emit(mc7::Operation operation, const mc7::Operand& operand) {
  const std::uint32_t at = offset();
  if (!mc7::encode({operation, operand}, code_)) return false;
  last_ = at;
  return true;
}

void CodeBuilder::jump(mc7::Operation operation, std::string label, Position position) {
  fixups_.push_back({offset(), std::move(label), std::move(position), false});
  (void)emit(operation, mc7::number(mc7::OperandKind::Jump, 0));
}

void CodeBuilder::jumpList(std::string label, Position position) {
  fixups_.push_back({offset(), std::move(label), std::move(position), true});
  (void)emit(mc7::Operation::SPL, mc7::number(mc7::OperandKind::JumpList, 0));
}

bool CodeBuilder::label(std::string name, Position position, Problems& problems) {
  if (labels_.try_emplace(name, offset()).second) return true;
  problems.add(ProblemCode::P0327, std::move(position), name);
  return false;
}

void CodeBuilder::parameterEntry(std::uint32_t pointer) { appendDWord(code_, pointer); }

void CodeBuilder::line(std::uint32_t line, std::uint32_t column) {
  if (!lines_.empty() && lines_.back().offset == offset())
    lines_.back() = {offset(), line, column};
  else
    lines_.push_back({offset(), line, column});
}

void CodeBuilder::network(std::string title) { networks_.push_back({offset(), std::move(title)}); }

void CodeBuilder::networkTitle(std::string title) {
  if (networks_.empty()) network({});
  networks_.back().title = std::move(title);
}

void CodeBuilder::patch(const Fixup& fixup, std::uint32_t target, Problems& problems) {
  const std::int64_t words = (static_cast<std::int64_t>(target) - fixup.offset) / 2;
  if (!fixup.list) {
    if (words < -32768 || words > 32767) {  // S7-INSTR-111
      problems.add(ProblemCode::P0328, fixup.position, fixup.label);
      return;
    }
    storeWord(&code_[fixup.offset + 2], static_cast<std::uint32_t>(words));
    return;
  }
  // The label must stand directly behind the list of SPA.
  const std::int64_t entries = words / 2 - 1;
  bool list = words >= 2 && words % 2 == 0 && entries <= 255;
  for (std::int64_t i = 0; list && i < entries; ++i)
    list = loadWord(&code_[fixup.offset + 4 + static_cast<std::size_t>(i) * 4]) == 0x700B;
  if (!list) {
    problems.add(ProblemCode::P0329, fixup.position, fixup.label);
    return;
  }
  storeWord(&code_[fixup.offset + 2], static_cast<std::uint32_t>(entries));
}

void CodeBuilder::resolveJumps(Problems& problems) {
  for (const Fixup& fixup : fixups_) {
    const auto target = labels_.find(fixup.label);
    if (target == labels_.end())
      problems.add(ProblemCode::P0330, fixup.position, fixup.label);
    else
      patch(fixup, target->second, problems);
  }
}

std::vector<std::string> CodeBuilder::jumpTargets() const {
  std::map<std::uint32_t, std::string> names;
  for (const Fixup& fixup : fixups_)
    if (const auto target = labels_.find(fixup.label); target != labels_.end())
      names.try_emplace(target->second, fixup.label);
  std::vector<std::string> out;
  for (auto& [offset, name] : names) out.push_back(std::move(name));
  return out;
}

void CodeBuilder::moveInto(block::Block& block) {
  block.jumps = mc7::jumpPositions(code_);
  block.code = std::move(code_);
  block.lines = std::move(lines_);
  block.networks = std::move(networks_);
  block.labels = jumpTargets();
  block.checks = std::move(checks_);
}

}  // namespace merker::step7
