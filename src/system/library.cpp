#include "system/library.h"

#include "system/function.h"

namespace merker::system {
namespace {

constexpr std::uint16_t kLongestString = 254;

block::TypePtr typeOf(const Parameter& parameter) {
  if (parameter.type == TypeCode::String) return block::stringType(kLongestString);
  return block::elementaryType(parameter.type);
}

block::Block blockOf(const Function& function) {
  block::Block result;
  result.id = {function.kind, function.number};
  result.symbol = result.attributes.name = std::string(function.name);
  result.attributes.family = function.kind == BlockKind::FC ? "IEC" : "SYSTEM";
  for (const Parameter& parameter : function.parameters) {
    block::Variable variable;
    variable.name = std::string(parameter.name);
    variable.section = parameter.section;
    variable.type = typeOf(parameter);
    if (parameter.section == block::Section::Return) result.returnType = variable.type;
    result.variables.push_back(std::move(variable));
  }
  const BitAddress end = block::layOut(result.variables, 0, true);
  if (function.kind == BlockKind::SFB) result.instanceBytes = end / 8;
  return result;
}

}  // namespace

block::Program library(const CpuModel& model) {
  block::Program program;
  for (const Function& function : allFunctions(model)) {
    block::Block block = blockOf(function);
    program.emplace(block.id, std::move(block));
  }
  return program;
}

}  // namespace merker::system
