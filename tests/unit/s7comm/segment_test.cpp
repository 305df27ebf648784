// BSEND on the wire (S7-SFB-10); the octets are those that Snap7's partner sends and takes.
#include "s7comm/segment.h"

#include <gtest/gtest.h>

#include "../hex.h"

namespace merker::s7comm {
namespace {

std::optional<Segment> segmentOf(const Bytes& bytes) {
  const auto pdu = readPdu(bytes);
  return pdu ? readSegment(*pdu) : std::nullopt;
}

const char* const kOnly =
    "32 07 00 00 00 05 00 0C 00 10 00 01 12 08 12 46 01 00 00 00 00 00 "
    "FF 09 00 0C 12 06 13 00 00 00 00 2A 00 02 AA BB";
const char* const kSecond =
    "32 07 00 00 00 06 00 0C 00 0E 00 01 12 08 12 46 01 07 02 01 00 00 "
    "FF 09 00 0A 12 06 13 00 00 00 00 2A CC DD";

TEST(Segment, TheOnlyOneSaysItsLength) {
  const Bytes octets = {0xAA, 0xBB};
  EXPECT_EQ(toHex(writeSegment(5, {.rid = 42, .total = 2, .octets = octets})), kOnly);
  const Bytes bytes = hex(kOnly);
  const auto segment = segmentOf(bytes);
  ASSERT_TRUE(segment);
  EXPECT_EQ(segment->rid, 42u);
  EXPECT_EQ(segment->total, 2);
  EXPECT_TRUE(segment->last);
  EXPECT_EQ(toHex(segment->octets), "AA BB");
}

TEST(Segment, OneThatFollowsHasTheSequenceOfItsAnswer) {
  const Bytes octets = {0xCC, 0xDD};
  EXPECT_EQ(toHex(writeSegment(
                6, {.rid = 42, .sequence = 7, .unit = 2, .last = false, .octets = octets})),
            kSecond);
  const Bytes bytes = hex(kSecond);
  const auto segment = segmentOf(bytes);
  ASSERT_TRUE(segment);
  EXPECT_EQ(segment->sequence, 7);
  EXPECT_EQ(segment->total, std::nullopt);
  EXPECT_FALSE(segment->last);
  EXPECT_EQ(toHex(segment->octets), "CC DD");
}

TEST(Segment, ItsAnswerHasNoData) {
  const char* const kAnswer =
      "32 07 00 00 00 06 00 0C 00 04 00 01 12 08 12 86 01 07 00 00 84 05 0A 00 00 00";
  EXPECT_EQ(toHex(writeSegmentAnswer(6, {7, Error::BlockDisabled})), kAnswer);
  const Bytes bytes = hex(kAnswer);
  const auto pdu = readPdu(bytes);
  ASSERT_TRUE(pdu);
  EXPECT_EQ(blockPdu(*pdu), BlockPdu::Answer);
  EXPECT_EQ(readSegmentAnswer(*pdu)->error, Error::BlockDisabled);
}

// Cut anywhere, with another group, another subfunction, another syntax, without octets.
TEST(Segment, WrongOnesAreNone) {
  const Bytes good = hex(kOnly);
  for (std::size_t length = 0; length < good.size(); ++length)
    EXPECT_FALSE(segmentOf(Bytes(good.begin(), good.begin() + static_cast<long>(length))));
  for (const std::size_t at : {15u, 16u, 26u, 28u}) {
    Bytes bad = good;
    bad[at] ^= 1;
    const auto pdu = readPdu(bad);
    EXPECT_TRUE(blockPdu(*pdu) == BlockPdu::None || !readSegment(*pdu)) << at;
  }
  EXPECT_FALSE(
      segmentOf(hex("32 07 00 00 00 05 00 0C 00 0E 00 01 12 08 12 46 01 00 00 00 00 00 "
                    "FF 09 00 0A 12 06 13 00 00 00 00 2A 00 02")));
}

TEST(Segment, FillsThePdu) {
  for (const bool first : {true, false}) {
    Segment segment{.rid = 1, .sequence = 1};
    if (first) segment = {.rid = 1, .total = std::uint16_t{500}};
    const Bytes octets(segmentRoom(240, first));
    segment.octets = octets;
    EXPECT_EQ(writeSegment(1, segment).size(), 240u);
  }
}

}  // namespace
}  // namespace merker::s7comm
