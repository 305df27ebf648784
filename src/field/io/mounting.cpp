#include "io/mounting.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace merker::io {
namespace {

constexpr std::uint32_t kPowerSlot = 1, kCpuSlot = 2, kInterfaceSlot = 3, kFirstSlot = 4,
                        kLastSlot = 11;

bool isInterface(const Module& module, std::string_view name) {
  return module.type->name == name && module.type->kind == ModuleKind::Interface;
}

const Module* interfaceOf(const Configuration& configuration, std::uint32_t rack) {
  for (const Module& module : configuration.modules)
    if (module.rack == rack && module.type->kind == ModuleKind::Interface) return &module;
  return nullptr;
}

Position slotPlace(const Module& module) {
  return module.slotPosition.line != 0 ? module.slotPosition : module.position;
}
Position rackPlace(const Module& module) {
  return module.rackPosition.line != 0 ? module.rackPosition : module.position;
}

struct SlotRule {
  ModuleKind kind;
  std::uint32_t slot;
  std::string_view words;
};
constexpr SlotRule kSlots[] = {
    {ModuleKind::PowerSupply, kPowerSlot, "a power supply must be in slot 1"},
    {ModuleKind::Interface, kInterfaceSlot, "an interface module must be in slot 3"}};

bool slotFits(const Module& module, Problems& problems) {
  const auto wrong = [&](std::string_view words) {
    problems.add(ProblemCode::P0726, slotPlace(module), title(*module.type), module.slot, words);
    return false;
  };
  for (const SlotRule& rule : kSlots)
    if (module.type->kind == rule.kind) return module.slot == rule.slot || wrong(rule.words);
  return module.slot >= kFirstSlot || wrong("SM, FM and CP must be in slots 4 to 11");
}

// IM 360: rack 0, IM 361: racks 1 to 3, IM 365: racks 0 and 1 (S7-HW-10).
bool rackFits(const Module& module, Problems& problems) {
  const auto wrong = [&](std::string_view words) {
    problems.add(ProblemCode::P0728, rackPlace(module), title(*module.type), module.rack, words);
    return false;
  };
  if (isInterface(module, "IM 360")) return module.rack == 0 || wrong("it must be in rack 0");
  if (isInterface(module, "IM 361")) return module.rack > 0 || wrong("it must be in racks 1 to 3");
  if (isInterface(module, "IM 365")) return module.rack <= 1 || wrong("it connects racks 0 and 1");
  return true;
}

std::string racksOf(const CpuModel& model) {
  return model.racks == 1 ? "only rack 0" : fmt::format("racks 0 to {}", model.racks - 1);
}

// S7-HW-33
void checkGaps(const Configuration& configuration, Problems& problems) {
  std::map<std::uint32_t, std::uint32_t> expected;  // by rack: the slot that comes next
  for (const Module& module : configuration.modules) {
    if (module.slot < kFirstSlot) continue;
    std::uint32_t& next = expected.try_emplace(module.rack, kFirstSlot).first->second;
    if (module.slot > next)
      problems.add(
          ProblemCode::P0732, slotPlace(module),
          module.rack == 0 ? fmt::format("{}", next) : fmt::format("{}/{}", module.rack, next));
    next = module.slot + 1;
  }
}

// Interface modules pass on from rack to rack, so that no rack is left out.
void checkRackGaps(const Configuration& configuration, Problems& problems) {
  std::uint32_t next = 0;
  for (const Module& module : configuration.modules) {
    if (module.rack > std::max(next, 1u))
      problems.add(ProblemCode::P0749, rackPlace(module), std::max(next, 1u));
    next = module.rack + 1;
  }
}

// Behind an IM 365 there is no communication bus (manual "CPU 31xC and CPU 31x: Installation",
// interface modules): FM and CP cannot be reached there.
void checkCommunicationBus(const Configuration& configuration, Problems& problems) {
  for (const Module& module : configuration.modules) {
    const Module* im = module.rack == 0 ? nullptr : interfaceOf(configuration, module.rack);
    if (im != nullptr && isInterface(*im, "IM 365") && module.type->placeholder())
      problems.add(ProblemCode::P0728, rackPlace(module), title(*module.type), module.rack,
                   "behind an IM 365 there is no communication bus, only SM work there");
  }
}

// S7-HW-15: each rack of several has its IM, and the IMs belong together.
void checkInterface(const Configuration& configuration, std::uint32_t rack, Problems& problems) {
  const bool pair = interfaceOf(configuration, 0) != nullptr &&
                    isInterface(*interfaceOf(configuration, 0), "IM 365");
  const std::string_view wanted = pair ? "IM 365" : rack == 0 ? "IM 360" : "IM 361";
  const Module* module = interfaceOf(configuration, rack);
  if (module == nullptr) {
    const auto& all = configuration.modules;
    const auto any = std::find_if(all.begin(), all.end(), [&](const Module& m) {
      return m.rack == std::max(rack, 1u) && m.position.line != 0;
    });
    if (any == all.end()) return;
    problems.add(ProblemCode::P0729, rackPlace(*any), rack,
                 rack == 0 ? "several racks need IM 360 or IM 365 in rack 0"
                           : fmt::format("it needs {}", wanted));
  } else if (pair && rack > 1) {
    problems.add(ProblemCode::P0728, rackPlace(*module), title(*module->type), rack,
                 "IM 365 connects no more than racks 0 and 1");
  } else if (!isInterface(*module, wanted) && !isInterface(*module, "IM 365") && rack > 0) {
    problems.add(ProblemCode::P0728, rackPlace(*module), title(*module->type), rack,
                 fmt::format("{} is in rack 0, so rack {} needs {}", pair ? "IM 365" : "IM 360",
                             rack, wanted));
  } else if (rack > 0 && isInterface(*module, "IM 365") && !pair) {
    problems.add(ProblemCode::P0728, rackPlace(*module), title(*module->type), rack,
                 "its counterpart must be in slot 3 of rack 0");
  }
}

void checkInterfaces(const Configuration& configuration, Problems& problems) {
  const auto& all = configuration.modules;
  for (std::uint32_t rack = 1; rack < configuration.model->racks; ++rack) {
    if (std::none_of(all.begin(), all.end(), [&](const Module& m) { return m.rack == rack; }))
      continue;
    if (interfaceOf(configuration, 0) == nullptr) return checkInterface(configuration, 0, problems);
    checkInterface(configuration, rack, problems);
  }
}

// S7-HW-16
void checkCables(const Configuration& configuration, Problems& problems) {
  for (const Module& module : configuration.modules)
    if (module.cable && (*module.cable > 10 || *module.cable <= 0))
      problems.add(ProblemCode::P0730, module.cablePosition, *module.cable);
}

// Points at the last module of the rack: with it the sum became too large.
void checkCurrent(const Configuration& configuration, Problems& problems) {
  const auto& all = configuration.modules;
  std::uint32_t sum = 0;
  for (std::uint32_t rack = 0; rack < configuration.model->racks; ++rack) {
    const Current mA = current(configuration, rack);
    sum += mA.taken;
    const auto last = std::find_if(all.rbegin(), all.rend(), [&](const Module& m) {
      return m.rack == rack && m.position.line != 0;
    });
    if (last == all.rend()) continue;
    const Module* im = interfaceOf(configuration, 0);
    const bool shared = im != nullptr && isInterface(*im, "IM 365") && rack > 0;
    if (mA.taken > mA.possible)
      problems.add(ProblemCode::P0731, last->position, fmt::format("rack {}", rack), mA.taken,
                   mA.possible);
    else if (shared && sum > configuration.model->busCurrent)
      problems.add(ProblemCode::P0731, last->position, "both racks", sum,
                   configuration.model->busCurrent);
  }
}

// S7-CPU-12, -13: those on board count (S7-OPEN-45).
void checkChannels(const Configuration& configuration, Problems& problems) {
  const Channels sum = channels(configuration);
  const auto& all = configuration.modules;
  const auto check = [&](std::uint32_t count, std::uint32_t most, std::string_view kind,
                         auto counts) {
    if (count <= most) return;
    const auto last = std::find_if(all.rbegin(), all.rend(), [&](const Module& m) {
      return m.position.line != 0 && counts(*m.type);
    });
    problems.add(ProblemCode::P0736, last == all.rend() ? Position{} : last->position, count, kind,
                 configuration.model->name, most);
  };
  check(sum.digital(), configuration.model->digitalChannels, "digital",
        [](const ModuleType& t) { return t.digitalInputs + t.digitalOutputs > 0; });
  check(sum.analog(), configuration.model->analogChannels, "analog",
        [](const ModuleType& t) { return t.analogInputs + t.analogOutputs > 0; });
}

}  // namespace

bool checkPlace(const Module& module, const CpuModel& model, Problems& problems) {
  if (module.rack >= model.racks) {
    problems.add(ProblemCode::P0724, rackPlace(module), module.rack, model.name, racksOf(model));
    return false;
  }
  if (module.onBoard()) return true;
  if (module.slot < kPowerSlot || module.slot > kLastSlot) {
    problems.add(ProblemCode::P0723, slotPlace(module), module.slot,
                 "a rack has slots 1 to 11, with at most 8 modules in slots 4 to 11");
    return false;
  }
  if (module.slot == kCpuSlot) {
    problems.add(ProblemCode::P0727, slotPlace(module), module.rack,
                 module.rack == 0 ? "is reserved for the CPU of [cpu]"
                                  : "is not available: a rack with IM 361 or IM 365 has no CPU");
    return false;
  }
  return slotFits(module, problems) && rackFits(module, problems);
}

void checkMounting(const Configuration& configuration, Problems& problems) {
  checkGaps(configuration, problems);
  checkRackGaps(configuration, problems);
  checkInterfaces(configuration, problems);
  checkCommunicationBus(configuration, problems);
  checkCables(configuration, problems);
  checkCurrent(configuration, problems);
  checkChannels(configuration, problems);
}

}  // namespace merker::io
