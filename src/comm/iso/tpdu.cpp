#include "iso/tpdu.h"

#include <algorithm>

#include "base/bytes.h"

namespace merker::iso {
namespace {

constexpr std::uint8_t kVersion = 3, kEndOfMessage = 0x80;
constexpr std::uint8_t kSizeParameter = 0xC0, kCallingParameter = 0xC1, kCalledParameter = 0xC2;
// TPDU code, both references, class or reason.
constexpr std::size_t kConnectFixed = 6, kDisconnectConfirmFixed = 5, kErrorFixed = 4;

using Read = Result<Tpdu, std::string_view>;

bool isConnect(TpduKind kind) {
  return kind == TpduKind::ConnectRequest || kind == TpduKind::ConnectConfirm;
}

void takeParameter(std::uint8_t code, View value, ConnectParameters& parameters) {
  if (code == kSizeParameter && value.size() == 1) parameters.sizeCode = value[0];
  if (code == kCallingParameter) parameters.calling.assign(value.begin(), value.end());
  if (code == kCalledParameter) parameters.called.assign(value.begin(), value.end());
}

// Code, length, value; codes that are not known here are passed over (RFC 905, 13.2.3).
bool readParameters(View bytes, ConnectParameters& parameters) {
  while (!bytes.empty()) {
    if (bytes.size() < 2 || bytes.size() - 2 < bytes[1]) return false;
    takeParameter(bytes[0], bytes.subspan(2, bytes[1]), parameters);
    bytes = bytes.subspan(2u + bytes[1]);
  }
  return true;
}

Read readReferences(View header, Tpdu tpdu) {
  const bool confirm = tpdu.kind == TpduKind::DisconnectConfirm;
  if (header.size() < (confirm ? kDisconnectConfirmFixed : kConnectFixed))
    return std::string_view("the header of the TPDU is too short");
  tpdu.destination = loadWord(&header[1]);
  tpdu.source = loadWord(&header[3]);
  if (confirm) return tpdu;
  if (tpdu.kind == TpduKind::DisconnectRequest) tpdu.reason = header[5];
  if (!isConnect(tpdu.kind)) return tpdu;
  tpdu.transportClass = header[5] >> 4;
  if (!readParameters(header.subspan(kConnectFixed), tpdu.parameters))
    return std::string_view("a parameter is longer than the TPDU");
  return tpdu;
}

Read readData(View header, View data, Tpdu tpdu) {
  if (header.size() != 2) return std::string_view("the header of DT must have 2 octets");
  tpdu.last = (header[1] & kEndOfMessage) != 0;
  tpdu.data = data;
  return tpdu;
}

void parameter(Bytes& out, std::uint8_t code, View value) {
  if (value.empty() || value.size() > 32) return;
  out.push_back(code);
  out.push_back(static_cast<std::uint8_t>(value.size()));
  out.insert(out.end(), value.begin(), value.end());
}

// Length of the packet and length indicator of the TPDU, once both are known.
void setLengths(Bytes& out, std::size_t begin) {
  storeWord(&out[begin + 2], static_cast<std::uint32_t>(out.size() - begin));
  out[begin + kTpktHeader] = static_cast<std::uint8_t>(out.size() - begin - kTpktHeader - 1);
}

}  // namespace

std::optional<std::size_t> packetLength(View header) {
  constexpr std::size_t kShortest = 7;  // RFC 1006: the header and a TPDU of 3 octets
  const std::size_t length = loadWord(&header[2]);
  if (header[0] != kVersion || length < kShortest) return std::nullopt;
  return length;
}

Read readPacket(View packet) {
  const View tpdu = packet.subspan(kTpktHeader);
  const std::size_t indicator = tpdu[0];  // octets of the header behind it
  if (indicator == 0 || indicator == 0xFF || indicator > tpdu.size() - 1)
    return std::string_view("the length indicator is wrong");
  const View header = tpdu.subspan(1, indicator), data = tpdu.subspan(1 + indicator);
  // The low half is the credit of other classes.
  Tpdu result{.kind = static_cast<TpduKind>(header[0] & 0xF0)};
  switch (result.kind) {
    case TpduKind::Data:
      return readData(header, data, result);
    case TpduKind::Error:
      if (header.size() < kErrorFixed) return std::string_view("the header of ER is too short");
      result.reason = header[3];
      return result;
    case TpduKind::ConnectRequest:
    case TpduKind::ConnectConfirm:
    case TpduKind::DisconnectRequest:
    case TpduKind::DisconnectConfirm:
      return readReferences(header, result);
  }
  return std::string_view("this TPDU does not exist in class 0");
}

void writePacket(Bytes& out, const Tpdu& tpdu) {
  const std::size_t begin = out.size();
  out.insert(out.end(), {kVersion, 0, 0, 0, 0, static_cast<std::uint8_t>(tpdu.kind)});
  appendWord(out, tpdu.destination);
  appendWord(out, tpdu.source);
  if (isConnect(tpdu.kind)) out.push_back(static_cast<std::uint8_t>(tpdu.transportClass << 4));
  if (tpdu.kind == TpduKind::DisconnectRequest) out.push_back(tpdu.reason);
  if (isConnect(tpdu.kind)) {
    if (tpdu.parameters.sizeCode)
      parameter(out, kSizeParameter, View(&*tpdu.parameters.sizeCode, 1));
    parameter(out, kCallingParameter, tpdu.parameters.calling);
    parameter(out, kCalledParameter, tpdu.parameters.called);
  }
  setLengths(out, begin);
}

void writeData(Bytes& out, View data, bool last) {
  const std::size_t length = kTpktHeader + kDataHeader + data.size();
  out.insert(out.end(), {kVersion, 0});
  appendWord(out, static_cast<std::uint32_t>(length));
  out.insert(out.end(), {2, static_cast<std::uint8_t>(TpduKind::Data),
                         last ? kEndOfMessage : std::uint8_t{0}});
  out.insert(out.end(), data.begin(), data.end());
}

}  // namespace merker::iso
