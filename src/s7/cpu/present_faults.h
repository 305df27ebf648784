// Faults that have come and not gone yet: they light SF, BF and BATF.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "catalogue/module_event.h"

namespace merker::cpu {

struct PresentFaults {
  struct Module {
    ModuleEvent::Kind kind = ModuleEvent::Kind::DiagnosticComing;
    std::uint16_t address = 0;
    bool output = false;
    std::uint32_t racks = 0;  // of a rack failure, a bit for each
    bool operator==(const Module&) const = default;
  };
  std::vector<Module> modules;  // kinds that come: diagnostic, removed, rack failed
  bool battery = false;
  bool program = false;  // an error of the program since the last restart

  bool any() const { return battery || program || !modules.empty(); }
  bool racks() const {
    using Kind = ModuleEvent::Kind;
    return std::any_of(modules.begin(), modules.end(), [](const Module& m) {
      return m.kind == Kind::RackFailed || m.kind == Kind::StationFailed;
    });
  }
  void come(const Module& module) {
    if (std::find(modules.begin(), modules.end(), module) == modules.end())
      modules.push_back(module);
  }
  void go(const Module& module) { std::erase(modules, module); }
};

}  // namespace merker::cpu
