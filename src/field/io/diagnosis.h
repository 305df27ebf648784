// Diagnostic data of a module: data record 1, of which record 0 is the beginning (S7-OBI-09).
#pragma once

#include <cstdint>
#include <vector>

#include "io/configuration.h"
#include "io/module_faults.h"

namespace merker::io {

inline constexpr std::size_t kRecord0 = 4;  // bytes

std::vector<std::uint8_t> diagnosis(const ModuleType& type, const ModuleFaults& faults);
// Of a CP 343-2: the slaves that do not answer, a bit for each address.
void addMissingSlaves(std::vector<std::uint8_t>& record, std::uint32_t slaves);

}  // namespace merker::io
