#include "served/resources.h"

#include <numeric>

namespace merker::served {

Resource resourceOf(std::span<const std::uint8_t> called) {
  if (called.empty()) return Resource::Basic;
  return called[0] == 1 ? Resource::Pg : called[0] == 2 ? Resource::Op : Resource::Basic;
}

unsigned Resources::inUse() const { return std::accumulate(used_.begin(), used_.end(), 0u); }

// By others: the one of a programming device or panel that has not come.
unsigned Resources::keptFor(Resource kind) const {
  return kind != Resource::Basic && used_[static_cast<std::size_t>(kind)] == 0 ? 1 : 0;
}

bool Resources::take(Resource kind) {
  unsigned free = kConnections - inUse();
  for (const Resource other : {Resource::Pg, Resource::Op})
    if (other != kind) free -= keptFor(other);
  if (free == 0) return false;
  ++used(kind);
  return true;
}

}  // namespace merker::served
