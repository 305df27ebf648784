#include "catalogue/ethernet.h"

#include <algorithm>

namespace merker {
namespace {

// Device manual "CPU 31xC and CPU 31x: Technical Data"; the generic models have every interface.
constexpr std::string_view kEthernetCpus[] = {"314C-2 PN/DP", "generic", "generic-4"};
// S7-NET-16; catalogue of HW Config.
constexpr std::string_view kItCp = "CP 343-1 IT";
constexpr std::string_view kEthernetModules[] = {"CP 343-1", kItCp};

}  // namespace

bool hasEthernet(const CpuModel& model) {
  return std::ranges::count(kEthernetCpus, model.keyword) > 0;
}

bool hasEthernet(const ModuleType& type) {
  return std::ranges::count(kEthernetModules, type.name) > 0;
}

bool isItCp(const ModuleType& type) { return type.name == kItCp; }

}  // namespace merker
