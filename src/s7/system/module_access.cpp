#include "system/module_access.h"

#include <algorithm>

namespace merker::system {

ModuleBase baseOf(const ModuleInfo& module) {
  const bool output = module.inputs.count == 0 ||
                      (module.outputs.count != 0 && module.outputs.first < module.inputs.first);
  return output ? ModuleBase{kOutputArea, module.outputs.first}
                : ModuleBase{kInputArea, module.inputs.first};
}

std::optional<ModuleInfo> moduleAt(Modules* modules, std::uint32_t area, std::uint32_t address,
                                   AddressRule rule) {
  if (modules == nullptr || (area != kInputArea && area != kOutputArea)) return std::nullopt;
  for (const ModuleInfo& module : modules->all()) {
    const AddressRange& range = area == kInputArea ? module.inputs : module.outputs;
    if (range.contains(address) && (rule == AddressRule::Any || range.first == address))
      return module;
  }
  return std::nullopt;
}

std::optional<ModuleInfo> moduleIn(Modules* modules, const ModulePlace& place) {
  if (modules == nullptr) return std::nullopt;
  for (const ModuleInfo& module : modules->all())
    if (module.place == place) return module;
  return std::nullopt;
}

std::uint32_t refusal(const ModuleInfo& module) {
  constexpr std::uint32_t kEmpty = 0x80B2, kWrongType = 0x80B3;
  return !module.plugged ? kEmpty : module.wrongType ? kWrongType : 0;
}

}  // namespace merker::system
