#include "ethernet.h"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <linux/if_packet.h>
#include <net/if.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <string_view>

namespace merker::app {
namespace {

using Octets = std::array<std::uint8_t, 4>;

Octets octetsOf(const sockaddr* address) {
  sockaddr_in four{};
  std::memcpy(&four, address, sizeof four);
  Octets octets{};
  std::memcpy(octets.data(), &four.sin_addr, octets.size());
  return octets;
}

bool isFamily(const ifaddrs& one, int family) {
  return one.ifa_addr != nullptr && one.ifa_addr->sa_family == family;
}

bool fits(const ifaddrs& one, const Octets& wanted) {
  if (!isFamily(one, AF_INET)) return false;
  if (wanted == Octets{}) return (one.ifa_flags & IFF_LOOPBACK) == 0;
  // All of 127.0.0.0/8 is the same interface.
  const Octets there = octetsOf(one.ifa_addr);
  return there == wanted || (wanted[0] == 127 && there[0] == 127);
}

// The MAC address stands in another entry of the same name.
std::array<std::uint8_t, 6> hardwareOf(const ifaddrs* all, std::string_view name) {
  std::array<std::uint8_t, 6> hardware{};
  for (const ifaddrs* one = all; one != nullptr; one = one->ifa_next) {
    if (one->ifa_name != name || !isFamily(*one, AF_PACKET)) continue;
    sockaddr_ll link{};
    std::memcpy(&link, one->ifa_addr, sizeof link);
    std::copy_n(std::begin(link.sll_addr), hardware.size(), hardware.begin());
  }
  return hardware;
}

}  // namespace

std::optional<system::EthernetInterface> ethernetAt(const std::string& address) {
  Octets wanted{};
  if (inet_pton(AF_INET, address.c_str(), wanted.data()) != 1) return std::nullopt;
  ifaddrs* found = nullptr;
  if (getifaddrs(&found) != 0) return std::nullopt;
  const std::unique_ptr<ifaddrs, decltype(&freeifaddrs)> all(found, freeifaddrs);
  for (const ifaddrs* one = all.get(); one != nullptr; one = one->ifa_next) {
    if (!fits(*one, wanted)) continue;
    const Octets own = wanted == Octets{} ? octetsOf(one->ifa_addr) : wanted;
    const Octets mask = one->ifa_netmask == nullptr ? Octets{} : octetsOf(one->ifa_netmask);
    return system::EthernetInterface{own, mask, hardwareOf(all.get(), one->ifa_name)};
  }
  return std::nullopt;
}

}  // namespace merker::app
