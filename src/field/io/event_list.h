// What the modules of a rack have to tell the CPU: interrupts, and modules that come and go.
#pragma once

#include <utility>
#include <vector>

#include "catalogue/module_event.h"
#include "io/configuration.h"

namespace merker::io {

class EventList {
 public:
  // Channels that change at one instant are one interrupt, until the CPU has taken it (S7-OBI-06).
  void interrupt(const Module& module, std::uint32_t points);
  // OB 82, with the beginning of data record 1 (S7-OBI-09).
  void diagnosis(const Module& module, const std::vector<std::uint8_t>& record, bool coming);
  void presence(const Module& module, ModuleEvent::Kind kind);

  bool any() const { return presenceChanged_ || !events_.empty(); }
  std::vector<ModuleEvent> take() { return std::exchange(events_, {}); }  // in order
  bool takePresenceChanged() { return std::exchange(presenceChanged_, false); }

 private:
  std::vector<ModuleEvent> events_;
  bool presenceChanged_ = true;
};

}  // namespace merker::io
