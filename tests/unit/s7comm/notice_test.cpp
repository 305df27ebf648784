// USEND on the wire (S7-SFB-10): the frame that Wireshark's dissector of S7 communication reads.
#include "s7comm/notice.h"

#include <gtest/gtest.h>

#include "../hex.h"

namespace merker::s7comm {
namespace {

// R_ID 42: a bit, an odd number of bytes and a word.
const char* const kThree =
    "32 07 00 00 00 05 00 0A 00 18 00 01 12 06 13 00 00 00 00 2A "
    "FF 00 00 03 00 03 00 01 01 00 00 04 00 18 AA BB CC 00 00 04 00 10 12 34";

std::vector<SentArea> areasOfSizes(std::initializer_list<std::size_t> sizes) {
  std::vector<SentArea> areas;
  for (const std::size_t size : sizes) areas.push_back({DataUnit::Byte, Bytes(size)});
  return areas;
}

TEST(Notice, HasAnItemForEachArea) {
  const std::vector<SentArea> areas = {
      {DataUnit::Bit, {1}}, {DataUnit::Byte, {0xAA, 0xBB, 0xCC}}, {DataUnit::Byte, {0x12, 0x34}}};
  EXPECT_EQ(toHex(writeNotice(5, 42, areas)), kThree);
  const Bytes bytes = hex(kThree);
  const auto pdu = readPdu(bytes);
  ASSERT_TRUE(pdu && isNotice(*pdu));
  const auto notice = readNotice(*pdu);
  ASSERT_TRUE(notice);
  EXPECT_EQ(notice->rid, 42u);
  ASSERT_EQ(notice->areas.size(), 3u);
  EXPECT_EQ(notice->areas[0].unit, DataUnit::Bit);
  EXPECT_EQ(toHex(notice->areas[1].octets), "AA BB CC");
  EXPECT_EQ(toHex(notice->areas[2].octets), "12 34");
}

// Printed: System and Standard Functions, volume 2/2, 21-4, "Exact User Data Size".
TEST(Notice, FillsThePduWithThePrintedLengths) {
  EXPECT_EQ(writeNotice(1, 1, areasOfSizes({212})).size(), 240u);
  EXPECT_EQ(writeNotice(1, 1, areasOfSizes({452})).size(), 480u);
  EXPECT_EQ(writeNotice(1, 1, areasOfSizes({224, 224})).size(), 480u);
  EXPECT_EQ(writeNotice(1, 1, areasOfSizes({110, 110, 110, 110})).size(), 480u);
}

TEST(Notice, WrongLengthsAreNone) {
  const Bytes good = hex(kThree);
  for (std::size_t length = 0; length < good.size(); ++length) {
    const Bytes cut(good.begin(), good.begin() + static_cast<long>(length));
    const auto pdu = readPdu(cut);
    EXPECT_FALSE(pdu && isNotice(*pdu) && readNotice(*pdu)) << length;
  }
  Bytes more = good;
  more[23] = 4;  // areas
  EXPECT_FALSE(readNotice(*readPdu(more)));
  Bytes other = good;
  other[14] = 0x12;  // the syntax of other userdata
  EXPECT_FALSE(isNotice(*readPdu(other)));
}

}  // namespace
}  // namespace merker::s7comm
