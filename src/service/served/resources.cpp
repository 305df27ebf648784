#include "served/resources.h"

#include <algorithm>
#include <numeric>

namespace merker::served {

Resource resourceOf(std::span<const std::uint8_t> called) {
  if (called.empty()) return Resource::Basic;
  return called[0] == 1 ? Resource::Pg : called[0] == 2 ? Resource::Op : Resource::Basic;
}

bool namesTheCpu(std::span<const std::uint8_t> called) {
  constexpr std::uint8_t kRack0Slot2 = 2;
  return called.size() == 2 && called[1] == kRack0Slot2;
}

void Resources::limit(const CommunicationParameters& parameters) {
  connections_ = parameters.connections;  // those that are configured are taken, used or not
  const auto configured = static_cast<std::uint32_t>(parameters.configured.size());
  if (connections_) *connections_ -= std::min(*connections_, configured);
  reserved_ = {parameters.pg, parameters.op, parameters.basic};
}

unsigned Resources::inUse() const { return std::accumulate(used_.begin(), used_.end(), 0u); }

// What is kept for other kinds and not in use yet is not free.
bool Resources::take(Resource kind) {
  const auto own = static_cast<std::size_t>(kind);
  std::uint32_t taken = inUse();
  for (std::size_t other = 0; other < used_.size(); ++other)
    if (other != own && reserved_[other] > used_[other]) taken += reserved_[other] - used_[other];
  if (connections_ && taken >= *connections_) return false;
  ++used_[own];
  return true;
}

}  // namespace merker::served
