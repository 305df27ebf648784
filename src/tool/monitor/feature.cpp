#include "monitor/feature.h"

#include <array>

namespace merker::monitor {
namespace {

constexpr std::array kFeatures{
    FeatureName{Feature::Breakpoints, "breakpoints", "breakpoints"},
    FeatureName{Feature::CyclePoints, "cyclePoints", "trigger points"},
    FeatureName{Feature::Stacks, "stacks", "stacks"},
    FeatureName{Feature::Information, "information", "module information"},
    FeatureName{Feature::Blocks, "blocks", "list of blocks"},
    FeatureName{Feature::Download, "download", "memory for single blocks"},
    FeatureName{Feature::Completion, "completion", "completion of its sources"},
    FeatureName{Feature::References, "references", "cross reference"},
    FeatureName{Feature::Symbols, "symbols", "symbol table"},
    FeatureName{Feature::Rack, "rack", "modules with terminals"},
    FeatureName{Feature::Plants, "plants", "plants at terminals"},
    FeatureName{Feature::Interrupts, "interrupts", "events that can be triggered"},
    FeatureName{Feature::Engine, "engine", "machine code"},
    FeatureName{Feature::Snapshots, "snapshots", "states that can be saved"},
    FeatureName{Feature::TimersByHand, "timersByHand", "timers that stop by hand"},
    FeatureName{Feature::ModeSwitch, "modeSwitch", "mode switch"},
    FeatureName{Feature::Leds, "leds", "LEDs"},
    FeatureName{Feature::Clock, "clock", "clock"},
    FeatureName{Feature::Nc, "nc", "numerical control"}};

constexpr bool inOrder() {
  for (std::size_t i = 0; i < kFeatures.size(); ++i)
    if (static_cast<std::size_t>(kFeatures[i].feature) != i) return false;
  return kFeatures.size() == static_cast<std::size_t>(Feature::Nc) + 1;
}
static_assert(inOrder());

}  // namespace

std::span<const FeatureName> features() { return kFeatures; }
std::string_view name(Feature feature) { return kFeatures[static_cast<std::size_t>(feature)].name; }
std::string_view what(Feature feature) { return kFeatures[static_cast<std::size_t>(feature)].what; }

}  // namespace merker::monitor
