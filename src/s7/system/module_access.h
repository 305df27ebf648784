// How system functions name a module: an address with its area, or a place.
#pragma once

#include <cstdint>
#include <optional>

#include "system/arguments.h"
#include "system/modules.h"

namespace merker::system {

constexpr std::uint32_t kInputArea = 0x54, kOutputArea = 0x55;  // IOID: PE, PA

// The area by which a module is called: that with the lower address, inputs if both are equal.
struct ModuleBase {
  std::uint32_t area = kInputArea;
  std::uint16_t address = 0;
};
ModuleBase baseOf(const ModuleInfo& module);

// The module that has this address; with `base` it must be the first of its range.
enum class AddressRule : std::uint8_t { Any, Base };
std::optional<ModuleInfo> moduleAt(Modules* modules, std::uint32_t area, std::uint32_t address,
                                   AddressRule rule);
std::optional<ModuleInfo> moduleIn(Modules* modules, const ModulePlace& place);

// 0, or why no data record can be exchanged with it.
std::uint32_t refusal(const ModuleInfo& module);

}  // namespace merker::system
