#include "cpu/diagnostics.h"

#include <utility>

#include "base/bytes.h"

namespace merker::cpu {

DiagnosticInformation informationOf(const Place& place) {
  DiagnosticInformation info{};
  if (!place.known) return info;
  info[0] = static_cast<std::uint8_t>(0x80u | static_cast<unsigned>(place.block.kind));
  storeWord(&info[4], place.block.number);
  storeWord(&info[6], place.offset);
  return info;
}

void Diagnostics::add(DiagnosticEvent event) {
  if (events_.size() == kCapacity) events_.erase(events_.begin());
  events_.push_back(std::move(event));
  ++added_;
}

void Diagnostics::replaced(const std::set<BlockId>& blocks) {
  for (DiagnosticEvent& event : events_) event.place.replaced |= blocks.contains(event.place.block);
}

}  // namespace merker::cpu
