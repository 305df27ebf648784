#include "monitor/feature.h"

#include <array>

namespace merker::monitor {
namespace {

constexpr std::array kFeatures{FeatureName{Feature::Breakpoints, "breakpoints"},
                               FeatureName{Feature::CyclePoints, "cyclePoints"},
                               FeatureName{Feature::Stacks, "stacks"},
                               FeatureName{Feature::Information, "information"},
                               FeatureName{Feature::Blocks, "blocks"},
                               FeatureName{Feature::Download, "download"},
                               FeatureName{Feature::Completion, "completion"},
                               FeatureName{Feature::References, "references"},
                               FeatureName{Feature::Symbols, "symbols"},
                               FeatureName{Feature::Rack, "rack"},
                               FeatureName{Feature::Plants, "plants"},
                               FeatureName{Feature::Interrupts, "interrupts"},
                               FeatureName{Feature::Engine, "engine"},
                               FeatureName{Feature::Snapshots, "snapshots"},
                               FeatureName{Feature::TimersByHand, "timersByHand"},
                               FeatureName{Feature::ModeSwitch, "modeSwitch"},
                               FeatureName{Feature::Leds, "leds"}};

constexpr bool inOrder() {
  for (std::size_t i = 0; i < kFeatures.size(); ++i)
    if (static_cast<std::size_t>(kFeatures[i].feature) != i) return false;
  return kFeatures.size() == static_cast<std::size_t>(Feature::Leds) + 1;
}
static_assert(inOrder());

}  // namespace

std::span<const FeatureName> features() { return kFeatures; }
std::string_view name(Feature feature) { return kFeatures[static_cast<std::size_t>(feature)].name; }

}  // namespace merker::monitor
