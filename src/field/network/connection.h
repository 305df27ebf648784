// One end of a configured connection between two stations (S7-NETPRO-08).
#pragma once

#include <cstdint>
#include <optional>

#include "address/connection_kind.h"

namespace merker::network {

class Node;

struct ConnectionEnd {
  Node* node = nullptr;               // of this station, on the subnet of the connection
  std::uint8_t partner = 0;           // its address there
  std::uint16_t number = 0;           // of the connection, the same at both ends
  std::optional<std::uint16_t> id{};  // as blocks name it; none: this end only serves the other
  bool active = false;                // this end calls
  ConnectionKind kind = ConnectionKind::S7;
};

}  // namespace merker::network
