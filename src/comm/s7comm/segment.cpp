#include "s7comm/segment.h"

#include "base/bytes.h"
#include "s7comm/data_item.h"
#include "s7comm/userdata.h"

namespace merker::s7comm {
namespace {

constexpr std::uint8_t kBlockGroup = 6, kBlockSend = 1;
constexpr std::size_t kBlockParameters = 12;  // with unit, last and error

// A variable specification of syntax 13h: R_ID.
constexpr std::uint8_t kReceiverSyntax[] = {0x12, 0x06, 0x13, 0x00};
constexpr std::size_t kReceiverOctets = sizeof kReceiverSyntax + 4, kTotalOctets = 2;

}  // namespace

std::size_t segmentRoom(std::size_t pdu, bool first) {
  return pdu - kUserdataOverhead - kReceiverOctets - (first ? kTotalOctets : 0);
}

Bytes writeSegment(std::uint16_t reference, const Segment& segment) {
  Bytes data(std::begin(kReceiverSyntax), std::end(kReceiverSyntax));
  appendDWord(data, segment.rid);
  if (segment.total) appendWord(data, *segment.total);
  data.insert(data.end(), segment.octets.begin(), segment.octets.end());
  return writeUserdata({.kind = UserdataHead::Kind::Request,
                        .group = kBlockGroup,
                        .subfunction = kBlockSend,
                        .sequence = segment.sequence,
                        .unit = segment.unit,
                        .last = segment.last},
                       reference, data);
}

Bytes writeSegmentAnswer(std::uint16_t reference, const SegmentAnswer& answer) {
  return writeUserdata({.kind = UserdataHead::Kind::Answer,
                        .group = kBlockGroup,
                        .subfunction = kBlockSend,
                        .sequence = answer.sequence,
                        .error = answer.error},
                       reference, {});
}

BlockPdu blockPdu(const Pdu& pdu) {
  const View p = pdu.parameters;
  if (pdu.type != PduType::Userdata || p.size() < 8 || (p[5] & 0x0F) != kBlockGroup)
    return BlockPdu::None;
  const auto kind = static_cast<UserdataHead::Kind>(p[5] & 0xC0);
  if (kind == UserdataHead::Kind::Request) return BlockPdu::Segment;
  return kind == UserdataHead::Kind::Answer ? BlockPdu::Answer : BlockPdu::None;
}

std::optional<Segment> readSegment(const Pdu& pdu) {
  const View p = pdu.parameters;
  View data = pdu.data;
  const auto item = readDataItem(data);
  if (p.size() < kBlockParameters || p[6] != kBlockSend || !item) return std::nullopt;
  View octets = item->octets;
  const bool first = p[7] == 0;
  if (octets.size() <= kReceiverOctets + (first ? kTotalOctets : 0)) return std::nullopt;
  for (std::size_t i = 0; i < sizeof kReceiverSyntax; ++i)
    if (octets[i] != kReceiverSyntax[i]) return std::nullopt;
  Segment segment{.rid = loadDWord(&octets[sizeof kReceiverSyntax]),
                  .sequence = p[7],
                  .unit = p[8],
                  .last = p[9] == 0};
  octets = octets.subspan(kReceiverOctets);
  if (first) {
    segment.total = loadWord(octets.data());
    octets = octets.subspan(kTotalOctets);
  }
  segment.octets = octets;
  return segment;
}

std::optional<SegmentAnswer> readSegmentAnswer(const Pdu& pdu) {
  const View p = pdu.parameters;
  if (p.size() < kBlockParameters || p[6] != kBlockSend) return std::nullopt;
  return SegmentAnswer{p[7], static_cast<Error>(loadWord(&p[10]))};
}

}  // namespace merker::s7comm
