// From what merker.toml says to a complete, checked configuration.
#include <algorithm>
#include <tuple>

#include "base/text.h"
#include "io/addresses.h"
#include "io/asi.h"
#include "io/configuration.h"
#include "io/mounting.h"

namespace merker::io {
namespace {

void addOnBoard(std::vector<Module>& modules, const CpuModel& model) {
  for (std::uint32_t subslot = 2; subslot <= 5; ++subslot) {
    const ModuleType* type = onBoardType(model, subslot);
    const bool mentioned = std::any_of(modules.begin(), modules.end(),
                                       [&](const Module& m) { return m.subslot == subslot; });
    if (type == nullptr || mentioned) continue;
    Module module;
    module.type = type;
    module.slot = 2;
    module.subslot = subslot;
    module.parameters = Parameters::of(*type);
    modules.push_back(std::move(module));
  }
}

// One module a slot; further ones are left out.
void dropTaken(std::vector<Module>& modules, Problems& problems) {
  const auto taken = [&](const Module& one, const Module& other) {
    const bool same = one.slotText() == other.slotText();
    if (same)
      problems.add(ProblemCode::P0725,
                   other.slotPosition.line != 0 ? other.slotPosition : other.position,
                   other.slotText(), one.title());
    return same;
  };
  modules.erase(std::unique(modules.begin(), modules.end(), taken), modules.end());
}

void checkNames(const std::vector<Module>& modules, Problems& problems) {
  for (auto one = modules.begin(); one != modules.end(); ++one)
    for (auto other = modules.begin(); other != one; ++other)
      if (!one->name.empty() && equalsIgnoreCase(one->name, other->name))
        problems.add(ProblemCode::P0742, one->position, one->name, "slot " + other->slotText());
  // A module is addressed by its name or its slot.
  for (const Module& one : modules)
    for (const Module& other : modules)
      if (&one != &other && one.name == other.slotText())
        problems.add(ProblemCode::P0742, one.position, one.name, "slot " + other.slotText());
}

}  // namespace

Configuration configure(std::vector<Module> modules, const CpuModel& model, Problems& problems) {
  std::erase_if(modules, [&](const Module& m) { return !checkPlace(m, model, problems); });
  addOnBoard(modules, model);
  std::stable_sort(modules.begin(), modules.end(), [](const Module& a, const Module& b) {
    return std::tie(a.rack, a.slot, a.subslot) < std::tie(b.rack, b.slot, b.subslot);
  });
  dropTaken(modules, problems);
  Configuration configuration{std::move(modules), &model};
  checkNames(configuration.modules, problems);
  assignAddresses(configuration);
  checkMounting(configuration, problems);
  checkAddresses(configuration, problems);
  addAsiSlaves(configuration, problems);
  return configuration;
}

}  // namespace merker::io
