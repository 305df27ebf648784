// The transport PDUs of ISO 8073 class 0 (RFC 905), each in one TPKT (RFC 1006 section 6).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace merker::iso {

using Bytes = std::vector<std::uint8_t>;
using View = std::span<const std::uint8_t>;

enum class TpduKind : std::uint8_t {
  Error = 0x70,
  DisconnectRequest = 0x80,
  DisconnectConfirm = 0xC0,
  ConnectConfirm = 0xD0,
  ConnectRequest = 0xE0,
  Data = 0xF0
};

// Of a disconnect request (RFC 905, 13.5.3 d).
enum class Reason : std::uint8_t {
  NotSpecified = 0,
  UnknownAddress = 3,
  Normal = 128,
  Congestion = 129,  // at the time of the request
  ClassNotSupported = 130,
  ProtocolError = 133,
  InvalidLength = 138
};

// The variable part of CR and CC (RFC 905, 13.3.4), in any order.
struct ConnectParameters {
  std::optional<std::uint8_t> sizeCode;  // 2^n octets of a TPDU: 7 … 13
  Bytes calling, called;                 // TSAPs
  bool operator==(const ConnectParameters&) const = default;
};

struct Tpdu {
  TpduKind kind = TpduKind::Data;
  std::uint16_t destination = 0, source = 0;  // references
  std::uint8_t transportClass = 0;
  std::uint8_t reason = 0;  // of DR and ER
  bool last = true;         // EOT of DT
  ConnectParameters parameters{};
  View data{};  // of DT, in the bytes that were read
};

constexpr std::size_t kTpktHeader = 4;  // RFC 1006: version 3, reserved, length
constexpr std::size_t kDataHeader = 3;  // of DT
constexpr std::size_t kMostPacket = 65'535;

// Of a TPKT whose first four octets are here: its length; nothing if it is none.
std::optional<std::size_t> packetLength(View header);
// A whole TPKT; or what is wrong with it.
Result<Tpdu, std::string_view> readPacket(View packet);

// Connection TPDUs as a TPKT.
void writePacket(Bytes& out, const Tpdu& tpdu);
// A part of a message.
void writeData(Bytes& out, View data, bool last);

}  // namespace merker::iso
