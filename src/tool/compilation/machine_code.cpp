#include "compilation/machine_code.h"

#include <fmt/format.h>

#include <algorithm>

namespace merker::compilation {
namespace {

std::vector<const block::Variable*> frame(const block::Block& block) {
  std::vector<const block::Variable*> list;
  for (const block::Variable& v : block.variables)
    if (v.section != block::Section::Temp) list.push_back(&v);
  return list;
}

bool sameInterface(const block::Block& a, const block::Block& b) {
  const auto first = frame(a), second = frame(b);
  return std::equal(first.begin(), first.end(), second.begin(), second.end(),
                    [](const block::Variable* x, const block::Variable* y) {
                      return x->section == y->section && block::sameStructure(*x->type, *y->type);
                    });
}

// The declaration with the code of the container.
block::Block merged(const block::Block& declared, const block::Block& container) {
  block::Block result = container;
  result.symbol = declared.symbol;
  result.variables = declared.variables;
  result.returnType = declared.returnType;
  result.initialData = declared.initialData;
  const bool knowHowProtect = container.attributes.knowHowProtect;
  result.attributes = declared.attributes;
  result.attributes.knowHowProtect |= knowHowProtect;
  result.file = declared.file;
  if (!declared.lines.empty())
    result.lines = {{0, declared.lines.front().line, declared.lines.front().column}};
  return result;
}

}  // namespace

block::Program withMachineCode(const block::Program& library,
                               const std::vector<project::MachineCode>& code) {
  block::Program result = library;
  for (const project::MachineCode& file : code) result.insert_or_assign(file.block.id, file.block);
  return result;
}

void addMachineCode(const std::vector<project::MachineCode>& code, block::Program& program,
                    Problems& problems) {
  for (const project::MachineCode& file : code) {
    const auto declared = program.find(file.block.id);
    if (declared == program.end()) {
      program.emplace(file.block.id, file.block).first->second.file = file.file;
    } else if (!sameInterface(declared->second, file.block) ||
               (file.block.id.kind == BlockKind::DB &&
                declared->second.actualData.size() != file.block.actualData.size())) {
      problems.add(ProblemCode::P0602, Position{file.file},
                   fmt::format("the interface of {} is not the one that {} declares",
                               toString(file.block.id), declared->second.file));
    } else {
      declared->second = merged(declared->second, file.block);
    }
  }
}

}  // namespace merker::compilation
