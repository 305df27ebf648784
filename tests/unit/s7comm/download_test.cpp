// Blocks for the PLC, and what is done with them: 1Ah to 1Ch, _INSE, _DELE.
#include <gtest/gtest.h>

#include "line.h"

namespace merker::s7comm {
namespace {

// DB 1, so many octets as its lengths say: of 4 digits; of these a digit of values.
std::string request(const std::string& octets, const std::string& files = "50", char code = '4') {
  std::string digits;
  for (const char digit : octets) digits += std::string(" 3") + digit;
  return "32 01 00 00 00 02 00 20 00 00 1A 00 01 00 00 00 00 00 09 5F 30 41 30 30 30 30 31 " +
         files + " 0D 31 30 30" + digits + " 30 30 30 30 30 3" + code;
}
constexpr std::string_view kAccepted = "32 03 00 00 00 02 00 01 00 00 00 00 1A | ";

// A job of the PLC: what it wants, an error.
std::string asks(const char* reference, const char* function, const char* error = "00 00") {
  return std::string("32 01 00 00 00 ") + reference + " 00 12 00 00 " + function + " 00 " + error +
         " 00 00 00 00 09 5F 30 41 30 30 30 30 31 50";
}

Bytes piece(std::uint8_t reference, std::uint8_t octets, bool more, std::uint8_t first = 0x70) {
  Bytes pdu = hex("32 03 00 00 00 00 00 02 00 00 00 00 1B 00 00 00 00 FB");
  pdu[5] = reference;
  pdu[9] = static_cast<std::uint8_t>(octets + 4);
  pdu[13] = more;
  pdu[15] = octets;
  pdu.resize(pdu.size() + octets, first);
  return pdu;
}

constexpr std::string_view kEnded = "32 03 00 00 00 03 00 01 00 00 00 00 1C";
constexpr std::string_view kInsert =
    "32 01 00 00 00 09 00 1A 00 00 28 00 00 00 00 00 00 FD 00 0A 01 00 30 41 30 30 30 30 31 50 "
    "05 5F 49 4E 53 45";

TEST(Download, thePlcAsksForPieces) {
  Line line;
  EXPECT_EQ(line.say(request("0300")), std::string(kAccepted) + asks("01", "1B"));
  EXPECT_TRUE(line.session->asks());
  EXPECT_EQ(line.say(piece(1, 200, true)), asks("02", "1B"));
  EXPECT_EQ(line.say(piece(2, 100, false)), asks("03", "1C"));
  EXPECT_EQ(line.say(kEnded), "");
  EXPECT_FALSE(line.session->asks());
  ASSERT_EQ(line.plc.kept.size(), 1u);
  EXPECT_EQ(line.plc.kept[0].first, (BlockName{BlockType::Db, 1, FileSystem::Passive}));
  EXPECT_EQ(line.plc.kept[0].second, Bytes(300, 0x70));
  EXPECT_EQ(line.say(kInsert), "32 03 00 00 00 09 00 01 00 00 00 00 28");
  EXPECT_EQ(line.plc.linked, (std::vector{BlockName{BlockType::Db, 1, FileSystem::Passive}}));
}

TEST(Download, thePlcMayTakeItsTime) {
  Line line;
  line.plc.later = true;
  EXPECT_EQ(line.say(request("0004")), "");
  line.plc.carryOutAll();
  EXPECT_EQ(line.heard(), std::string(kAccepted) + asks("01", "1B"));
  EXPECT_EQ(line.say(piece(1, 4, false)), "");
  line.plc.carryOutAll();
  EXPECT_EQ(line.heard(), asks("02", "1C"));
}

TEST(Download, whatIsRefusedAtOnce) {
  const auto refused = [](const std::string& error) {
    return "32 02 00 00 00 02 00 00 00 00 " + error;
  };
  Line line;
  EXPECT_EQ(line.say(request("1001")), refused("83 01"));
  EXPECT_EQ(line.say(request("0300", "41")), refused("D2 18"));
  EXPECT_EQ(line.say(request("03:0")), refused("D2 01"));
  EXPECT_EQ(line.say(request("0300", "50", '0')), refused("D2 19"));
  EXPECT_EQ(line.say(request("0004", "50", '5')), refused("D2 19"));
  EXPECT_EQ(line.say("32 01 00 00 00 02 00 02 00 00 1A 00"), refused("D2 01"));
  line.plc.locked = true;
  EXPECT_EQ(line.say(request("0300")), refused("D2 41"));
  EXPECT_FALSE(line.session->asks());
}

// The end of the download says why the block is of no use.
TEST(Download, aBadBlockIsNotKept) {
  Line line;
  line.say(request("0008"));
  EXPECT_EQ(line.say(piece(1, 4, false)), asks("02", "1C", "D2 19"));  // shorter than announced
  line.say(request("0004"));
  EXPECT_EQ(line.say(piece(3, 5, false)), asks("04", "1C", "80 03"));  // longer
  line.say(request("0004"));
  EXPECT_EQ(line.say(piece(5, 4, false, 0x71)), asks("06", "1C", "D2 26"));
  line.say(request("0004"));
  Bytes lies = piece(7, 4, false);
  lies[15] = 5;
  EXPECT_EQ(line.say(lies), asks("08", "1C", "80 03"));
  EXPECT_TRUE(line.plc.kept.empty());
  EXPECT_EQ(line.say(kInsert), "32 03 00 00 00 09 00 02 00 00 D2 09 28 02");
}

TEST(Download, theClientMayGiveUp) {
  Line line;
  line.say(request("0008"));
  EXPECT_EQ(line.say("32 02 00 00 00 01 00 00 00 00 84 04"), "");
  EXPECT_FALSE(line.session->asks());
  EXPECT_EQ(line.say(piece(1, 4, true)), "");
}

// An answer to nothing, or to what was asked before, is nothing; a new download ends the old one.
TEST(Download, answersBelongToQuestions) {
  Line line;
  EXPECT_EQ(line.say(piece(1, 4, true)), "");
  line.say(request("0008"));
  EXPECT_EQ(line.say(request("0004")), std::string(kAccepted) + asks("02", "1B"));
  EXPECT_EQ(line.say(piece(1, 4, true)), "");
  EXPECT_EQ(line.say(piece(2, 4, false)), asks("03", "1C"));
}

// A recorded conversation has the references that another CPU gave.
TEST(Download, anAnswerIsKnownByItsFunction) {
  Line line;
  line.say(request("0008"));
  EXPECT_EQ(line.say("32 03 00 00 30 00 00 01 00 00 00 00 1C"), "");
  EXPECT_EQ(line.say(piece(0x30, 4, true)), asks("02", "1B"));
  EXPECT_EQ(line.say(piece(0x31, 4, false)), asks("03", "1C"));
}

// The connection goes on without it.
TEST(Download, aSilentClientLosesIt) {
  Line line;
  line.say(request("0008"));
  EXPECT_TRUE(line.session->asks());
  line.session->giveUp();
  EXPECT_FALSE(line.session->asks());
  EXPECT_EQ(line.say(piece(1, 4, true)), "");
  EXPECT_EQ(line.say(request("0004")), std::string(kAccepted) + asks("02", "1B"));
}

TEST(Download, anAnswerMayComeBetweenTwoDownloads) {
  Line line;
  line.say(request("0008"));
  line.plc.later = true;
  EXPECT_EQ(line.say(request("0004")), "");
  EXPECT_EQ(line.say(piece(1, 4, true)), "");
  line.plc.carryOutAll();
  EXPECT_EQ(line.heard(), std::string(kAccepted) + asks("02", "1B"));
}

TEST(Download, itMayEndWhileNobodyIsThere) {
  FewBytes plc;
  auto session = std::make_shared<Session>(plc, [](const Bytes&) {});
  const std::weak_ptr watched = session;
  session->receive(hex("32 01 00 00 00 01 00 08 00 00 F0 00 00 08 00 08 01 E0"));
  session->receive(hex(request("0008")));
  EXPECT_TRUE(session->asks());
  session.reset();
  EXPECT_TRUE(watched.expired());
}

TEST(BlockService, severalAreDeleted) {
  Line line;
  EXPECT_EQ(line.say("32 01 00 00 00 09 00 22 00 00 28 00 00 00 00 00 00 FD 00 12 02 00 "
                     "30 41 30 30 30 30 31 42 30 43 30 30 30 31 32 41 05 5F 44 45 4C 45"),
            "32 03 00 00 00 09 00 01 00 00 00 00 28");
  EXPECT_EQ(line.plc.removed, (std::vector{BlockName{BlockType::Db, 1, FileSystem::Both},
                                           BlockName{BlockType::Fc, 12, FileSystem::Active}}));
}

TEST(BlockService, aListMustBeOne) {
  Line line;
  constexpr std::string_view kRefused = "32 02 00 00 00 09 00 00 00 00 D2 01";
  EXPECT_EQ(line.say("32 01 00 00 00 09 00 1A 00 00 28 00 00 00 00 00 00 FD 00 0A 02 00 "
                     "30 41 30 30 30 30 31 42 05 5F 44 45 4C 45"),
            kRefused);
  EXPECT_EQ(line.say("32 01 00 00 00 09 00 1A 00 00 28 00 00 00 00 00 00 FD 00 0A 01 00 "
                     "30 41 30 30 30 30 31 43 05 5F 44 45 4C 45"),
            kRefused);
  EXPECT_EQ(
      line.say("32 01 00 00 00 09 00 10 00 00 28 00 00 00 00 00 00 FD 00 00 05 5F 44 45 4C 45"),
      kRefused);
}

TEST(Control, compressCopyAndMemoryReset) {
  Line line;
  EXPECT_EQ(
      line.say("32 01 00 00 00 09 00 10 00 00 28 00 00 00 00 00 00 FD 00 00 05 5F 47 41 52 42"),
      "32 03 00 00 00 09 00 01 00 00 00 00 28");
  constexpr std::string_view kCopy =
      "32 01 00 00 00 09 00 12 00 00 28 00 00 00 00 00 00 FD 00 02 45 50 05 5F 4D 4F 44 55";
  constexpr std::string_view kReset =
      "32 07 00 00 05 00 00 08 00 04 00 01 12 04 11 41 0C 00 0A 00 00 00";
  EXPECT_EQ(line.say(kCopy), "32 03 00 00 00 09 00 02 00 00 84 04 28 02");
  EXPECT_EQ(line.say(kReset),
            "32 07 00 00 05 00 00 0C 00 04 00 01 12 08 12 81 0C 00 00 00 D0 81 0A 00 00 00");
  line.plc.runs = false;
  EXPECT_EQ(line.say(kCopy), "32 03 00 00 00 09 00 01 00 00 00 00 28");
  EXPECT_EQ(line.say(kReset),
            "32 07 00 00 05 00 00 0C 00 04 00 01 12 08 12 81 0C 00 00 00 00 00 0A 00 00 00");
}

}  // namespace
}  // namespace merker::s7comm
