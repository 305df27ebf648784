// Global data of a station (S7-NET-27): what it sends to all and takes from all, a packet of a GD
// circle each.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "address/area.h"

namespace merker::network {

constexpr std::uint32_t kLongestPacket = 22;  // bytes

// Bytes of E, A, M or a data block.
struct GlobalArea {
  Area area = Area::Flag;
  std::uint16_t db = 0;
  std::uint32_t byte = 0, length = 1;
};

struct GlobalPacket {
  std::uint8_t circle = 1, packet = 1;
  bool sends = false;  // else it takes it
  GlobalArea data;
  std::uint32_t rate = 8;              // it is sent at the end of every so manieth cycle
  std::optional<GlobalArea> status{};  // GDS, a double word
};

struct GlobalData {
  std::vector<GlobalPacket> packets;
  std::optional<GlobalArea> groupStatus{};  // GST, a double word
};

}  // namespace merker::network
