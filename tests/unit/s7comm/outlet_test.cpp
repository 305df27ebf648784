// What a PLC says unasked.
#include <gtest/gtest.h>

#include "line.h"

namespace merker::s7comm {
namespace {

const Indication kTwoOctets{.group = 2, .subfunction = 1, .sequence = 7, .octets = {0xAB, 0xCD}};
constexpr std::string_view kTwoOctetsSent =
    "32 07 00 00 00 00 00 0C 00 06 00 01 12 08 12 02 01 07 00 00 00 00 FF 09 00 02 AB CD";

TEST(Outlet, anIndicationIsUserdataOfType0) {
  Line line;
  EXPECT_FALSE(line.session->outlet()->announce());
  EXPECT_TRUE(line.session->outlet()->send(kTwoOctets));
  EXPECT_TRUE(line.session->outlet()->announce());
  EXPECT_FALSE(line.session->outlet()->announce());  // once is enough
  EXPECT_EQ(line.heard(), "");
  line.session->outlet()->deliver();
  EXPECT_EQ(line.heard(), kTwoOctetsSent);
  line.session->outlet()->send(
      {.group = 1, .subfunction = 2, .sequence = 3, .error = Error::CannotBeDone});
  EXPECT_TRUE(line.session->outlet()->announce());
  line.session->outlet()->deliver();
  EXPECT_EQ(line.heard(),
            "32 07 00 00 00 00 00 0C 00 04 00 01 12 08 12 01 02 03 00 00 84 04 0A 00 00 00");
}

TEST(Outlet, aClientThatDoesNotReadLosesThem) {
  Line line;
  bool room = false;
  line.session->roomBy([&] { return room; });
  const auto outlet = line.session->outlet();
  for (std::size_t i = 0; i < Outlet::kMostWaiting; ++i) EXPECT_TRUE(outlet->send(kTwoOctets));
  outlet->deliver();
  EXPECT_EQ(line.heard(), "");
  EXPECT_FALSE(outlet->send(kTwoOctets));
  EXPECT_EQ(outlet->lost(), 1u);
  room = true;
  line.session->deliver();
  EXPECT_EQ(line.heard().size(), Outlet::kMostWaiting * (kTwoOctetsSent.size() + 3) - 3);
  EXPECT_TRUE(outlet->send(kTwoOctets));
}

TEST(Outlet, noneIsLongerThanThePdu) {
  Line line;
  EXPECT_EQ(line.session->outlet()->room(), 214u);
  EXPECT_TRUE(line.session->outlet()->send({.group = 1, .octets = Bytes(214)}));
  EXPECT_FALSE(line.session->outlet()->send({.group = 1, .octets = Bytes(215)}));
  line.session->deliver();
  EXPECT_EQ(line.heard().size(), 240u * 3 - 1);
}

TEST(Outlet, itOutlivesItsConnection) {
  auto line = std::make_unique<Line>();
  const auto outlet = line->session->outlet();
  outlet->send(kTwoOctets);
  line.reset();
  EXPECT_TRUE(outlet->isClosed());
  EXPECT_FALSE(outlet->send(kTwoOctets));
  outlet->deliver();
}

}  // namespace
}  // namespace merker::s7comm
