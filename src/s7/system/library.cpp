#include "system/library.h"

#include "system/function.h"

namespace merker::system {
namespace {

constexpr std::uint16_t kLongestString = 254;

block::TypePtr typeOf(const Parameter& parameter) {
  if (parameter.type == TypeCode::String) return block::stringType(kLongestString);
  return block::elementaryType(parameter.type);
}

// As it lies in a data block.
void setInitial(block::Variable& variable, std::uint32_t value) {
  const std::uint32_t bytes = (bitWidth(variable.type->code) + 7) / 8;
  for (std::uint32_t i = bytes; i-- > 0;)
    variable.initial.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  variable.hasInitial = true;
}

// SFB 0 to 5, IEC counters and timers, as a CPU 315-2 PN/DP has them; others: own decision.
std::string familyOf(const Function& function) {
  constexpr std::uint16_t kLastIec = 5;
  if (function.library == BlockLibrary::NetCp) return "CP300";
  if (function.kind == BlockKind::FC) return "IEC";
  return function.kind == BlockKind::SFB && function.number <= kLastIec ? "IEC_TC" : "SYSTEM";
}

block::Block blockOf(const Function& function) {
  block::Block result;
  result.id = {function.kind, function.number};
  result.symbol = result.attributes.name = std::string(function.name);
  result.attributes.author = "SIMATIC";
  result.attributes.family = familyOf(function);
  for (const Parameter& parameter : function.parameters) {
    block::Variable variable;
    variable.name = std::string(parameter.name);
    variable.section = parameter.section;
    variable.type = typeOf(parameter);
    if (parameter.initial != 0) setInitial(variable, parameter.initial);
    if (parameter.section == block::Section::Return) result.returnType = variable.type;
    result.variables.push_back(std::move(variable));
  }
  const BitAddress end = block::layOut(result.variables, 0, true);
  if (function.kind == BlockKind::SFB || function.kind == BlockKind::FB)
    result.instanceBytes = end / 8;
  return result;
}

}  // namespace

block::Program library(const CpuModel& model, const Libraries& libraries) {
  block::Program program;
  for (const Function& function : allFunctions(model, libraries)) {
    block::Block block = blockOf(function);
    program.emplace(block.id, std::move(block));
  }
  return program;
}

}  // namespace merker::system
