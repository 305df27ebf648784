#include "iso/transport.h"

#include <gtest/gtest.h>

#include "hex.h"

namespace merker::iso {
namespace {

using Kind = Event::Kind;
using Side = Transport::Side;

Event only(Transport& transport, View bytes) {
  transport.feed(bytes);
  const auto event = transport.next();
  return event ? *event : Event{.kind = Kind::Violated, .why = "nothing"};
}

Transport opened(std::string_view request = kRequest) {
  Transport transport(Side::Called);
  only(transport, hex(request));
  transport.confirm();
  return transport;
}

TEST(Transport, aRequestIsConfirmedWithItsReferenceAndSize) {
  Transport transport(Side::Called);
  EXPECT_EQ(only(transport, hex(kRequest)).kind, Kind::Requested);
  EXPECT_FALSE(transport.open());
  EXPECT_EQ(toHex(transport.confirm()), kConfirm);
  EXPECT_TRUE(transport.open());
}

TEST(Transport, aLargerSizeIsNegotiatedDown) {
  Transport transport(Side::Called);
  only(transport, hex("03 00 00 0E 09 E0 00 00 00 05 00 C0 01 0D"));
  EXPECT_EQ(toHex(transport.confirm()), "03 00 00 0E 09 D0 00 05 00 01 00 C0 01 0A");
}

TEST(Transport, aMessageComesWholeHoweverTheBytesAreCut) {
  const Bytes bytes = hex("03 00 00 09 02 F0 00 01 02 03 00 00 08 02 F0 80 03");
  for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
    Transport transport = opened();
    transport.feed(View(bytes).first(cut));
    auto event = transport.next();
    EXPECT_EQ(event.has_value(), cut == bytes.size());
    EXPECT_EQ(transport.unfinished(), cut > 0 && cut < bytes.size());
    transport.feed(View(bytes).subspan(cut));
    if (!event) event = transport.next();
    ASSERT_TRUE(event);
    EXPECT_EQ(toHex(event->message), "01 02 03");
    EXPECT_FALSE(transport.unfinished());
  }
}

TEST(Transport, messagesComeOneByOne) {
  Transport transport = opened();
  transport.feed(hex("03 00 00 08 02 F0 80 01 03 00 00 08 02 F0 80 02"));
  EXPECT_EQ(toHex(transport.next()->message), "01");
  EXPECT_EQ(transport.waiting(), 8u);
  EXPECT_EQ(toHex(transport.next()->message), "02");
  EXPECT_FALSE(transport.next());
}

TEST(Transport, aMessageHasAtMostOneMebibyte) {
  Transport transport = opened();
  Bytes part;
  writeData(part, Bytes(60'000), false);
  std::optional<Event> event;
  for (int i = 0; i < 17 && !event; ++i) {
    transport.feed(part);
    event = transport.next();
  }
  EXPECT_FALSE(event);  // 1,020,000 octets
  transport.feed(part);
  event = transport.next();
  ASSERT_TRUE(event);
  EXPECT_EQ(event->why, "a message must have at most 1 MiB");
}

// Programming devices send empty parts now and then.
TEST(Transport, aMessageHasAtMostTenThousandParts) {
  Transport transport = opened();
  Bytes part;
  writeData(part, {}, false);
  Bytes parts;
  for (int i = 0; i < 9'999; ++i) parts.insert(parts.end(), part.begin(), part.end());
  for (int i = 0; i < 2; ++i) {
    transport.feed(parts);
    EXPECT_FALSE(transport.next());
    transport.feed(hex("03 00 00 08 02 F0 80 AA"));
    const auto event = transport.next();
    ASSERT_TRUE(event);
    EXPECT_EQ(event->message, Bytes{0xAA});
  }
  parts.insert(parts.end(), part.begin(), part.end());
  parts.insert(parts.end(), part.begin(), part.end());
  transport.feed(parts);
  const auto event = transport.next();
  ASSERT_TRUE(event);
  EXPECT_EQ(event->why, "a message must have at most 10000 parts");
}

TEST(Transport, answersAreCutToTheAgreedSize) {
  Bytes out;
  opened("03 00 00 0E 09 E0 00 00 00 05 00 C0 01 07").write(out, Bytes(130, 0xAA));
  ASSERT_EQ(out.size(), 130u + 2 * 7);
  EXPECT_EQ(toHex(View(out).first(7)), "03 00 00 84 02 F0 00");
  EXPECT_EQ(toHex(View(out).subspan(132, 7)), "03 00 00 0C 02 F0 80");
  out.clear();
  opened("03 00 00 0B 06 E0 00 00 00 05 00").write(out, Bytes(2000));
  EXPECT_EQ(out.size(), 2007u);  // RFC 1006: 65531 octets without the parameter
}

TEST(Transport, whatIsNoConnectionEnds) {
  const auto why = [](std::string_view bytes) {
    Transport transport(Side::Called);
    const Event event = only(transport, hex(bytes));
    EXPECT_EQ(event.kind, Kind::Violated);
    transport.feed(hex(kRequest));
    EXPECT_FALSE(transport.next());
    return event.why;
  };
  EXPECT_EQ(why("47 45 54 20 2F"), "this is no TPKT of version 3");
  EXPECT_EQ(why("03 00 00 07 02 F0 80"), "data before the connection is confirmed");
  EXPECT_EQ(why("03 00 00 0B 06 E0 00 00 00 05 20"), "only transport class 0 is supported");
  EXPECT_EQ(why("03 00 00 0E 09 E0 00 00 00 05 00 C0 01 0E"), "the TPDU size must be 07 to 0D");
  EXPECT_EQ(why("03 00 00 0B 06 D0 00 00 00 05 00"), "nobody has asked for this confirmation");
}

TEST(Transport, aRefusalNamesItsReason) {
  Transport transport(Side::Called);
  EXPECT_EQ(toHex(only(transport, hex("03 00 00 0B 06 E0 00 00 00 05 40")).answer),
            "03 00 00 0B 06 80 00 05 00 01 82");
  Transport another(Side::Called);
  only(another, hex(kRequest));
  EXPECT_EQ(toHex(another.refuse(Reason::Congestion)), "03 00 00 0B 06 80 00 05 00 01 81");
}

TEST(Transport, aSecondRequestIsAProtocolError) {
  Transport transport = opened();
  const Event event = only(transport, hex(kRequest));
  EXPECT_EQ(event.why, "a connection is requested a second time");
  EXPECT_EQ(toHex(event.answer), "03 00 00 0B 06 80 00 05 00 01 85");
}

TEST(Transport, theOtherSideEndsIt) {
  Transport transport = opened();
  const Event event = only(transport, hex("03 00 00 0B 06 80 00 01 00 05 80"));
  EXPECT_EQ(event.kind, Kind::Disconnected);
  EXPECT_EQ(event.reason, 128);
  EXPECT_EQ(toHex(event.answer), "03 00 00 0A 05 C0 00 05 00 01") << "it is confirmed";
}

TEST(Transport, bothSidesUnderstandEachOther) {
  Transport calling(Side::Calling), called(Side::Called);
  const Event request = only(called, calling.request({{}, hex("01 00"), hex("01 02")}));
  EXPECT_EQ(request.parameters, (ConnectParameters{10, hex("01 00"), hex("01 02")}));
  EXPECT_EQ(only(calling, called.confirm()).kind, Kind::Confirmed);
  Bytes out;
  calling.write(out, Bytes(3000, 7));
  EXPECT_EQ(only(called, out).message, Bytes(3000, 7));
}

}  // namespace
}  // namespace merker::iso
