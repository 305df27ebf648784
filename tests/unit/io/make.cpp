#include "make.h"

#include <gtest/gtest.h>

#include "base/bytes.h"

namespace merker::io {

Module make(std::uint32_t rack, std::uint32_t slot, std::string_view type) {
  Module module;
  module.type = findModuleTypes(type).at(0);
  module.rack = rack;
  module.slot = slot;
  module.parameters = Parameters::of(*module.type);
  module.position = {"merker.toml", 10 * rack + slot + 1, 1};
  return module;
}

Module onBoard(std::uint32_t subslot, const CpuModel& model) {
  Module module;
  module.type = onBoardType(model, subslot);
  module.slot = 2;
  module.subslot = subslot;
  module.parameters = Parameters::of(*module.type);
  module.position = {"merker.toml", subslot, 1};
  return module;
}

Configuration good(std::vector<Module> modules, const CpuModel& model) {
  Problems problems;
  Configuration configuration = configure(std::move(modules), model, problems);
  for (const Problem& problem : problems.list()) ADD_FAILURE() << problem.message;
  return configuration;
}

std::vector<std::string> problemsOf(std::vector<Module> modules, const CpuModel& model) {
  Problems problems;
  configure(std::move(modules), model, problems);
  std::vector<std::string> codes;
  for (const Problem& problem : problems.list()) {
    EXPECT_NE(problem.position.line, 0u) << problem.message;
    codes.emplace_back(problem.name());
  }
  return codes;
}

std::uint16_t word(const Rack& rack, std::uint32_t byte) { return loadWord(&rack.inputs()[byte]); }

}  // namespace merker::io
