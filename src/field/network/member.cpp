#include "network/member.h"

namespace merker::network {

using controller::Controller;

Controller& Member::owner(const address::Reference& reference) const {
  return network_.itself(reference.station == 0 ? number_ : reference.station - 1u);
}

std::optional<std::uint32_t> Member::read(const address::Reference& reference) const {
  return owner(reference).read(reference);
}
bool Member::write(const address::Reference& reference, std::uint32_t value) {
  return owner(reference).write(reference, value);
}
bool Member::force(const address::Reference& reference, std::uint32_t value) {
  return owner(reference).force(reference, value);
}
std::optional<std::vector<std::uint8_t>> Member::readBytes(
    const address::Reference& reference) const {
  return owner(reference).readBytes(reference);
}
bool Member::writeBytes(const address::Reference& reference, std::span<const std::uint8_t> bytes) {
  return owner(reference).writeBytes(reference, bytes);
}
std::string Member::whyMissing(const address::Reference& reference) const {
  return owner(reference).whyMissing(reference);
}
std::string Member::whyRefused(const address::Reference& reference) const {
  return owner(reference).whyRefused(reference);
}

}  // namespace merker::network
