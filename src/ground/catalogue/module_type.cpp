#include "catalogue/module_type.h"

#include <cctype>

namespace merker {
namespace {

std::string bareName(std::string_view text) {
  std::string result;
  for (const char c : text)
    if (c != ' ' && c != '-')
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

bool fits(const ModuleType& type, const std::string& wanted) {
  return bareName(type.orderNumber) == wanted || bareName(title(type)) == wanted;
}

bool begins(const ModuleType& type, const std::string& wanted) {
  return bareName(type.orderNumber).starts_with(wanted) ||
         bareName(title(type)).starts_with(wanted);
}

const ModuleType* onBoard(ModuleKind kind, unsigned inputs) {
  for (const ModuleType& type : onBoardTypes())
    if (type.kind == kind && (kind != ModuleKind::Digital || type.digitalInputs == inputs))
      return &type;
  return nullptr;
}

}  // namespace

std::vector<const ModuleType*> findModuleTypes(std::string_view name) {
  const std::string wanted = bareName(name);
  std::vector<const ModuleType*> found, begun;
  if (wanted.empty()) return found;
  for (const ModuleType& type : moduleTypes()) {
    if (fits(type, wanted)) found.push_back(&type);
    if (begins(type, wanted)) begun.push_back(&type);
  }
  return found.empty() ? begun : found;
}

// S7-CPU-15 to -17
const ModuleType* onBoardType(const CpuModel& model, unsigned subslot) {
  const OnBoard& has = model.onBoard;
  if (subslot == 1 && has.serial) return onBoard(ModuleKind::PointToPoint, 0);
  if (subslot == 2 && has.digitalInputs > 0) return onBoard(ModuleKind::Digital, has.digitalInputs);
  if (subslot == 3 && has.analogInputs > 0) return onBoard(ModuleKind::Analog, has.analogInputs);
  if (subslot == 4 && has.counters > 0) return onBoard(ModuleKind::Counting, 0);
  if (subslot == 5 && has.positioning > 0) return onBoard(ModuleKind::Positioning, 0);
  return nullptr;
}

std::string title(const ModuleType& type) {
  return std::string(type.name) + (type.name.empty() || type.text.empty() ? "" : " ") +
         std::string(type.text);
}

}  // namespace merker
