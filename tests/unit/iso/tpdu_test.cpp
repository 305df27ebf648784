#include "iso/tpdu.h"

#include <gtest/gtest.h>

#include "hex.h"

namespace merker::iso {
namespace {

std::string whyNot(std::string_view packet) {
  const Bytes bytes = hex(packet);
  const auto tpdu = readPacket(bytes);
  return tpdu ? "" : std::string(tpdu.error());
}

TEST(Tpdu, aRequestNamesSizeAndTsapsInAnyOrder) {
  for (const auto text : {kRequest, std::string_view("03 00 00 16 11 E0 00 00 00 05 00 C1 02 01 00 "
                                                     "C2 02 01 02 C0 01 0A")}) {
    const Bytes bytes = hex(text);
    const auto tpdu = readPacket(bytes);
    ASSERT_TRUE(tpdu);
    EXPECT_EQ(tpdu->kind, TpduKind::ConnectRequest);
    EXPECT_EQ(tpdu->source, 5);
    EXPECT_EQ(tpdu->parameters, (ConnectParameters{10, hex("01 00"), hex("01 02")}));
  }
}

TEST(Tpdu, unknownParametersArePassedOver) {
  const Bytes bytes = hex("03 00 00 12 0D E0 00 00 00 05 00 87 01 55 C1 02 01 00");
  const auto tpdu = readPacket(bytes);
  ASSERT_TRUE(tpdu);
  EXPECT_EQ(toHex(tpdu->parameters.calling), "01 00");
}

TEST(Tpdu, dataHasItsEndMark) {
  const Bytes part = hex("03 00 00 09 02 F0 00 AA BB"), end = hex("03 00 00 08 02 F0 80 CC");
  EXPECT_FALSE(readPacket(part)->last);
  EXPECT_TRUE(readPacket(end)->last);
  EXPECT_EQ(toHex(readPacket(part)->data), "AA BB");
}

TEST(Tpdu, lengthsThatDoNotFitAreRefused) {
  EXPECT_EQ(whyNot("03 00 00 07 FF F0 80"), "the length indicator is wrong");
  EXPECT_EQ(whyNot("03 00 00 07 00 F0 80"), "the length indicator is wrong");
  EXPECT_EQ(whyNot("03 00 00 07 03 F0 80"), "the length indicator is wrong");
  EXPECT_EQ(whyNot("03 00 00 07 01 F0 80"), "the header of DT must have 2 octets");
  EXPECT_EQ(whyNot("03 00 00 0A 05 E0 00 00 00 05"), "the header of the TPDU is too short");
  EXPECT_EQ(whyNot("03 00 00 0E 09 E0 00 00 00 05 00 C1 09 01"),
            "a parameter is longer than the TPDU");
  EXPECT_EQ(whyNot("03 00 00 0C 07 E0 00 00 00 05 00 C1"), "a parameter is longer than the TPDU");
  EXPECT_EQ(whyNot("03 00 00 07 02 10 80"), "this TPDU does not exist in class 0");
}

TEST(Tpdu, aPacketHasVersionThreeAndSevenOctets) {
  EXPECT_EQ(packetLength(hex("03 00 00 07")), 7u);
  EXPECT_EQ(packetLength(hex("03 00 FF FF")), 65'535u);
  EXPECT_FALSE(packetLength(hex("03 00 00 06")));
  EXPECT_FALSE(packetLength(hex("02 00 00 16")));
}

TEST(Tpdu, whatIsWrittenIsOnTheWire) {
  Bytes out;
  writePacket(out, {.kind = TpduKind::ConnectConfirm,
                    .destination = 5,
                    .source = 1,
                    .parameters = {10, hex("01 00"), hex("01 02")}});
  EXPECT_EQ(toHex(out), kConfirm);
  out.clear();
  writePacket(out,
              {.kind = TpduKind::DisconnectRequest, .destination = 5, .source = 1, .reason = 128});
  EXPECT_EQ(toHex(out), "03 00 00 0B 06 80 00 05 00 01 80");
  out.clear();
  writeData(out, hex("32 01"), true);
  EXPECT_EQ(toHex(out), "03 00 00 09 02 F0 80 32 01");
}

}  // namespace
}  // namespace merker::iso
