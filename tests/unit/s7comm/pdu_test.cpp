#include "s7comm/pdu.h"

#include <gtest/gtest.h>

#include "line.h"
#include "s7comm/request.h"

namespace merker::s7comm {
namespace {

TEST(Pdu, setupAgreesOnTheSmallerValues) {
  Line line(false);
  EXPECT_EQ(line.say("32 01 00 00 04 00 00 08 00 00 F0 00 00 01 00 01 01 E0"),
            "32 03 00 00 04 00 00 08 00 00 00 00 F0 00 00 01 00 01 00 F0");
  EXPECT_EQ(line.say("32 01 00 00 04 00 00 08 00 00 F0 00 00 14 00 00 00 80"),
            "32 03 00 00 04 00 00 08 00 00 00 00 F0 00 00 08 00 01 00 80");
  EXPECT_EQ(line.session->pdu(), 128);
}

TEST(Pdu, aPduTooShortForAnAnswerIsRefused) {
  Line line(false);
  EXPECT_EQ(line.say("32 01 00 00 00 01 00 08 00 00 F0 00 00 01 00 01 00 6F"),
            "32 02 00 00 00 01 00 00 00 00 85 00");
  EXPECT_FALSE(line.session->isSetUp());
}

TEST(Pdu, nothingIsServedBeforeTheSetup) {
  Line line(false);
  EXPECT_EQ(line.say("32 01 00 00 00 02 00 0E 00 00 04 01 12 0A 10 02 00 01 00 00 83 00 00 00"),
            "32 02 00 00 00 02 00 00 00 00 81 04");
  EXPECT_EQ(line.say("32 07 00 00 00 02 00 08 00 00 00 01 12 04 11 44 01 00"),
            "32 02 00 00 00 02 00 00 00 00 81 04");
}

TEST(Pdu, anUnknownFunctionIsRefused) {
  EXPECT_EQ(Line().say("32 01 00 00 12 34 00 01 00 00 2A"), "32 02 00 00 12 34 00 00 00 00 81 04");
  EXPECT_EQ(Line().say("32 01 00 00 12 34 00 00 00 00"), "32 02 00 00 12 34 00 00 00 00 85 00");
}

// Cyclic reading; the answer has type, group and sequence number of it.
TEST(Pdu, userdataThatNobodyServesIsRefusedInItsOwnForm) {
  EXPECT_EQ(
      Line().say("32 07 00 00 05 00 00 08 00 08 00 01 12 04 11 42 08 07 FF 09 00 04 00 11 00 00"),
      "32 07 00 00 05 00 00 0C 00 04 00 01 12 08 12 82 08 07 00 00 81 04 0A 00 00 00");
  EXPECT_EQ(Line().say("32 07 00 00 05 00 00 08 00 00 00 01 12 09 11 44 01 00"),
            "32 02 00 00 05 00 00 00 00 00 85 00");
}

TEST(Pdu, whatIsNoPduEndsTheConnection) {
  for (const auto text :
       {"", "32", "31 01 00 00 00 01 00 00 00 00", "32 04 00 00 00 01 00 00 00 00",
        "32 01 00 00 00 01 00 09 00 00 F0 00 00 01 00 01 01 E0", "32 01 00 00 00 01 FF FF FF FF F0",
        "32 03 00 00 00 01 00 00 00 00"}) {
    Line line;
    EXPECT_EQ(line.say(std::string_view(text)), "");
    EXPECT_FALSE(line.good) << text;
  }
}

TEST(Pdu, anAnswerNobodyAskedForIsPassedOver) {
  Line line;
  EXPECT_EQ(line.say("32 03 00 00 00 09 00 00 00 00 00 00"), "");
  EXPECT_TRUE(line.good);
}

TEST(Pdu, aRequestLongerThanAgreedIsRefused) {
  Line line;
  Bytes request = hex("32 01 00 00 00 07 00 E7 00 00 04 00");
  request.resize(241);
  EXPECT_EQ(line.say(request), "32 02 00 00 00 07 00 00 00 00 85 00");
}

// What a client sends the session understands, and the other way round.
TEST(Pdu, bothSidesUnderstandEachOther) {
  Line line(false);
  const auto ask = [&](const Bytes& request) { return hex(line.say(request)); };
  const Bytes setup = ask(setupRequest(1, {960, 4}));
  EXPECT_EQ(setupAnswer(*readPdu(setup))->pdu, 240);
  EXPECT_EQ(setupAnswer(*readPdu(setup))->jobs, 4);
  const AnyItem items[] = {{.type = ElementType::Bit, .address = 8 * 3 + 2},
                           {.type = ElementType::Real, .block = 1, .memory = Memory::DataBlock}};
  const Bytes values[] = {{1}, {0x3F, 0xC0, 0, 0}};
  const Bytes written = ask(writeRequest(2, items, values));
  EXPECT_EQ(writeAnswer(*readPdu(written)), (std::vector{ItemCode::Done, ItemCode::Done}));
  const Bytes read = ask(readRequest(3, items));
  const auto back = readAnswer(*readPdu(read));
  ASSERT_TRUE(back);
  EXPECT_EQ((*back)[0].octets, values[0]);
  EXPECT_EQ((*back)[1].octets, values[1]);
}

// Snap7's server gives an item that has failed a length of 4 and no octets.
TEST(Pdu, anItemThatHasFailedHasNoOctets) {
  const Bytes parameters = {4, 2};
  const Bytes data = {0x0A, 0, 0, 4, 0xFF, 4, 0, 8, 0x55};
  const auto values = readAnswer({.type = PduType::Answer, .parameters = parameters, .data = data});
  ASSERT_TRUE(values);
  EXPECT_EQ((*values)[0].code, ItemCode::Missing);
  EXPECT_EQ((*values)[0].octets, Bytes{});
  EXPECT_EQ((*values)[1].octets, Bytes{0x55});
}

}  // namespace
}  // namespace merker::s7comm
