#include "io/module_faults.h"

#include <algorithm>

namespace merker::io {

bool ModuleFaults::put(FaultKind kind, std::optional<std::uint32_t> channel, bool there) {
  const auto change = [&](std::uint16_t& bits) {
    bits = static_cast<std::uint16_t>(there ? bits | bitOf(kind) : bits & ~bitOf(kind));
  };
  if (nameOf(kind).channel) {
    for (std::uint32_t c = 0; c < put_.size(); ++c)
      if (!channel || *channel == c) change(put_[c]);
    return true;
  }
  if (has(kind) == there) return false;
  change(ofModule_);
  return true;
}

bool ModuleFaults::hasAnywhere(FaultKind kind) const {
  return has(kind) || std::ranges::any_of(
                          put_, [&](std::uint16_t faults) { return (faults & bitOf(kind)) != 0; });
}

}  // namespace merker::io
