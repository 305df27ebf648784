#include "io/event_list.h"

#include <algorithm>

namespace merker::io {
namespace {

using Kind = ModuleEvent::Kind;

// Its address and RACKS_FLTD (S7-OBI-11): a bit for each rack; a DP station has those of its
// master.
ModuleEvent rackEvent(const Module& module, bool failed) {
  if (module.station == 0)
    return {.kind = failed ? Kind::RackFailed : Kind::RackReturned, .points = 1u << module.rack};
  return {.kind = failed ? Kind::StationFailed : Kind::StationReturned,
          .address = module.master,
          .points = module.station};
}

ModuleEvent event(const Module& module, Kind kind) {
  ModuleEvent event{.kind = kind};
  event.output = !module.inputStart && module.outputStart;
  const std::uint32_t diagnosis = module.station >> 16;  // of the head of a slave
  event.address = static_cast<std::uint16_t>(
      module.inputStart.value_or(module.outputStart.value_or(diagnosis)));
  return event;
}

}  // namespace

void EventList::interrupt(const Module& module, std::uint32_t points) {
  ModuleEvent fresh = event(module, Kind::HardwareInterrupt);
  fresh.points = points;
  const auto same = std::ranges::find_if(events_, [&](const ModuleEvent& other) {
    return other.kind == fresh.kind && other.address == fresh.address &&
           other.output == fresh.output && (other.points & points) == 0;
  });
  if (same == events_.end()) return events_.push_back(fresh);
  same->points |= points;
}

void EventList::diagnosis(const Module& module, const std::vector<std::uint8_t>& record,
                          bool coming) {
  ModuleEvent interrupt = event(module, coming ? Kind::DiagnosticComing : Kind::DiagnosticGoing);
  std::copy_n(record.begin(), interrupt.data.size(), interrupt.data.begin());
  events_.push_back(interrupt);
}

void EventList::presence(const Module& module, Kind kind) {
  presenceChanged_ = true;
  const bool rack = kind == Kind::RackFailed || kind == Kind::RackReturned;
  events_.push_back(rack ? rackEvent(module, kind == Kind::RackFailed) : event(module, kind));
}

}  // namespace merker::io
