#include "cpu/diagnostics.h"

#include <utility>

namespace merker::cpu {

void Diagnostics::add(DiagnosticEvent event) {
  if (events_.size() == kCapacity) events_.erase(events_.begin());
  events_.push_back(std::move(event));
  ++added_;
}

}  // namespace merker::cpu
