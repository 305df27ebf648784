// Requests that are there to harm.
#include <gtest/gtest.h>

#include "line.h"

namespace merker::s7comm {
namespace {

// A public server dies of it (2026): 65535 elements of a byte, or of eight.
TEST(Hostile, aCountOf65535IsRefusedBeforeAnythingIsRead) {
  for (const auto type : {"01", "02", "04", "06", "08", "0F"}) {
    Line line;
    const std::string answer = line.say("32 01 00 00 00 02 00 0E 00 00 04 01 12 0A 10 " +
                                        std::string(type) + " FF FF 00 01 84 00 00 00");
    EXPECT_TRUE(answer.starts_with("32 03 00 00 00 02 00 02 00 0")) << answer;
    EXPECT_TRUE(line.good);
    EXPECT_EQ(line.plc.largest, 0u);
  }
}

TEST(Hostile, manyItemsThatAreTooMuchTogether) {
  Line line;
  Bytes request = hex("32 01 00 00 00 02 00 DA 00 00 04 12");
  for (int i = 0; i < 18; ++i) {
    const Bytes item = hex("12 0A 10 02 00 10 00 01 84 00 00 00");
    request.insert(request.end(), item.begin(), item.end());
  }
  EXPECT_EQ(line.say(request), "32 03 00 00 00 02 00 02 00 00 85 00 04 00");
  EXPECT_EQ(line.plc.largest, 0u);
}

TEST(Hostile, moreItemsThanParameters) {
  EXPECT_EQ(Line().say("32 01 00 00 00 02 00 0E 00 00 04 FF 12 0A 10 02 00 01 00 00 83 00 00 00"),
            "32 03 00 00 00 02 00 02 00 00 85 00 04 00");
  EXPECT_EQ(Line().say("32 01 00 00 00 02 00 02 00 00 04 00"),
            "32 03 00 00 00 02 00 02 00 00 85 00 04 00");
  EXPECT_EQ(Line().say("32 01 00 00 00 02 00 01 00 00 04"),
            "32 03 00 00 00 02 00 02 00 00 85 00 04 00");
}

// Each PDU cut off at each place, and each of its bytes changed to each value: always an answer or
// the end, never more than a PDU.
TEST(Hostile, everyByteMayBeWrong) {
  const Bytes request =
      hex("32 01 00 00 00 02 00 1A 00 0C 05 02 12 0A 10 02 00 01 00 00 83 00 00 00 "
          "12 0A 10 1D 00 01 00 00 1D 00 00 08 00 04 00 08 AA 00 00 09 00 02 11 22");
  Line line;
  const auto hears = [&](const Bytes& pdu) {
    const std::string answer = line.say(pdu);
    EXPECT_EQ(answer.empty(), !line.good || (pdu[1] == 2 || pdu[1] == 3)) << toHex(pdu);
    EXPECT_LE(answer.size(), 240u * 3);
  };
  for (std::size_t i = 1; i < request.size(); ++i) {
    Bytes changed = request;
    for (unsigned value = 0; value < 256; ++value) {
      changed[i] = static_cast<std::uint8_t>(value);
      hears(changed);
    }
    EXPECT_EQ(line.say(Bytes(request.begin(), request.begin() + static_cast<std::ptrdiff_t>(i))),
              "");
  }
}

}  // namespace
}  // namespace merker::s7comm
