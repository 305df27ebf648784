// The password of a connection. "hidden" is on the wire 3D 3C 0C 0D 3C 36 49 43.
#include <gtest/gtest.h>

#include "line.h"

namespace merker::s7comm {
namespace {

constexpr std::string_view kEnter =
    "32 07 00 00 01 00 00 08 00 0C 00 01 12 04 11 45 01 00 FF 09 00 08 3D 3C 0C 0D 3C 36 49 43";
constexpr std::string_view kCancel =
    "32 07 00 00 01 00 00 08 00 04 00 01 12 04 11 45 02 00 0A 00 00 00";

std::string answer(const std::string& subfunction, const std::string& error) {
  return "32 07 00 00 01 00 00 0C 00 04 00 01 12 08 12 85 " + subfunction + " 00 00 00 " + error +
         " 0A 00 00 00";
}

TEST(Password, isEnteredAndCancelled) {
  Line line;
  line.plc.locked = true;
  constexpr std::string_view kUpload =
      "32 01 00 00 00 02 00 12 00 00 1D 00 00 00 00 00 00 00 09 5F 30 38 30 30 30 30 31 41";
  EXPECT_EQ(line.say(kUpload), "32 02 00 00 00 02 00 00 00 00 D2 41");
  EXPECT_EQ(line.say(kEnter), answer("01", "00 00"));
  EXPECT_TRUE(line.say(kUpload).starts_with("32 03 00 00 00 02 00 10 00 00 00 00 1D"));
  EXPECT_EQ(line.say(kEnter), answer("01", "D6 04"));
  EXPECT_EQ(line.say(kCancel), answer("02", "00 00"));
  EXPECT_EQ(line.say(kUpload), "32 02 00 00 00 02 00 00 00 00 D2 41");
  EXPECT_EQ(line.say(kCancel), answer("02", "D6 04"));
}

TEST(Password, aWrongOneIsRefused) {
  Line line;
  line.plc.secret = "other";
  EXPECT_EQ(line.say(kEnter), answer("01", "D6 02"));
  line.plc.secret.clear();
  EXPECT_EQ(line.say(kEnter), answer("01", "D6 05"));
  EXPECT_EQ(line.say("32 07 00 00 01 00 00 08 00 06 00 01 12 04 11 45 01 00 FF 09 00 02 3D 3C"),
            answer("01", "D6 02"));
}

// One is looked at when the guard says so; what comes behind it waits. One that the guard does not
// admit is not looked at.
TEST(Password, aGuardLetsThemWait) {
  Line line;
  std::vector<std::function<void(bool)>> held;
  std::vector<Error> refused;
  int wrong = 0;
  line.session->guardBy({.refused = [&](Error error) { refused.push_back(error); },
                         .turn = [&](auto look) { held.push_back(look); },
                         .wrong = [&] { ++wrong; }});
  EXPECT_EQ(line.say(kEnter), "");
  EXPECT_EQ(line.say(kCancel), "");
  held.at(0)(true);
  EXPECT_EQ(line.heard(), answer("01", "00 00") + " | " + answer("02", "00 00"));
  line.plc.secret = "other";
  line.say(kEnter);
  held.at(1)(true);
  EXPECT_EQ(line.heard(), answer("01", "D6 02"));
  EXPECT_EQ(wrong, 1);
  line.plc.secret = "hidden";
  line.say(kEnter);
  held.at(2)(false);
  EXPECT_EQ(line.heard(), answer("01", "D6 02"));
  EXPECT_EQ(wrong, 1);
  EXPECT_EQ(refused, (std::vector{Error::WrongPassword, Error::WrongPassword}));
}

}  // namespace
}  // namespace merker::s7comm
