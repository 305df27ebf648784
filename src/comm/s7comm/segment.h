// Group 6 of userdata, BSEND: a telegram in segments, each acknowledged before the next one comes.
#pragma once

#include <optional>

#include "s7comm/pdu.h"

namespace merker::s7comm {

struct Segment {
  std::uint32_t rid = 0;
  std::uint8_t sequence = 0;             // 0: the first one; then what that was acknowledged with
  std::uint8_t unit = 0;                 // counts the segments from 1; 0: there is only one
  bool last = true;                      // none follows
  std::optional<std::uint16_t> total{};  // octets of the telegram: the first one says it
  View octets{};
};

// Octets that fit into a segment.
std::size_t segmentRoom(std::size_t pdu, bool first);
Bytes writeSegment(std::uint16_t reference, const Segment& segment);

struct SegmentAnswer {
  std::uint8_t sequence = 0;
  Error error = Error::None;
};
Bytes writeSegmentAnswer(std::uint16_t reference, const SegmentAnswer& answer);

// Whether a PDU belongs to this group at all, and what it is.
enum class BlockPdu : std::uint8_t { None, Segment, Answer };
BlockPdu blockPdu(const Pdu& pdu);
// Nothing: its lengths are wrong.
std::optional<Segment> readSegment(const Pdu& pdu);
std::optional<SegmentAnswer> readSegmentAnswer(const Pdu& pdu);

}  // namespace merker::s7comm
