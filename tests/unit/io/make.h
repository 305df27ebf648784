// Modules for tests.
#pragma once

#include "io/rack.h"

namespace merker::io {

Module make(std::uint32_t rack, std::uint32_t slot, std::string_view type);
Module onBoard(std::uint32_t subslot, const CpuModel& model = defaultCpuModel());
Configuration good(std::vector<Module> modules, const CpuModel& model = defaultCpuModel());
// Codes of the problems of a configuration, in the order they were found.
std::vector<std::string> problemsOf(std::vector<Module> modules,
                                    const CpuModel& model = defaultCpuModel());

constexpr Instant at(std::int64_t ms) { return Instant{ms * 1'000'000}; }
std::uint16_t word(const Rack& rack, std::uint32_t byte);

}  // namespace merker::io
