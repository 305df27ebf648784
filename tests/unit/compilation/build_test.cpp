#include "compilation/build.h"

#include <gtest/gtest.h>

#include <stop_token>

namespace merker::compilation {
namespace {

Build built(const std::string& name, const std::string& text) {
  return build(project::load(name, {}, {{name, text}}), false);
}

bool isThere(const Build& build, const char* operand) {
  const auto found = build.resolver()(operand, Position{"t.scn", 1, 1});
  EXPECT_TRUE(found || found.error().code == ProblemCode::P0962) << operand;
  return static_cast<bool>(found);
}

const std::string kShortBlock =
    "DATA_BLOCK DB 1\nSTRUCT\na : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";

std::string calling(const std::string& text) {
  return kShortBlock + "FUNCTION FC 1 : VOID\nVAR_TEMP\nno : WORD;\nreturned : INT;\nEND_VAR\n" +
         "BEGIN\nNETWORK\n" + text + "END_FUNCTION\n";
}

TEST(Operands, aMissingDataBlockIsAProblem) {
  const Build plain = built("a.awl", calling("NOP 0;\n"));
  ASSERT_TRUE(plain.ok());
  EXPECT_TRUE(isThere(plain, "DB1.DBW 0"));
  EXPECT_FALSE(isThere(plain, "DB1.DBW 2"));
  EXPECT_FALSE(isThere(plain, "DB9.DBW 0"));
}

// S7-SFC-10: a data block may come while the program runs; what else is missing stays missing.
TEST(Operands, aProgramThatMakesDataBlocksMayMakeThisOne) {
  const Build making = built(
      "a.awl", calling("CALL SFC 22 (LOW_LIMIT := W#16#9, UP_LIMIT := W#16#9, COUNT := W#16#4,\n"
                       "RET_VAL := #returned, DB_NUMBER := #no);\n"));
  ASSERT_TRUE(making.ok());
  EXPECT_TRUE(isThere(making, "DB9.DBW 0"));
  EXPECT_FALSE(isThere(making, "DB1.DBW 2"));
  EXPECT_FALSE(isThere(making, "PEW 700"));
}

TEST(Operands, ofThePartnerAreNamedAsSuch) {
  Build control = built("a.s5", "OB 1\nBE\n");
  const Position at{"t.scn", 1, 1};
  const auto alone = control.resolver()("partner.MB 10", at);
  ASSERT_FALSE(alone);
  EXPECT_EQ(alone.error().code, ProblemCode::P1155);
  control.partner = std::make_shared<const Build>(built("b.s5", "OB 1\nBE\n"));
  const auto coupled = control.resolver()("partner.MB 10", at);
  ASSERT_TRUE(coupled);
  EXPECT_TRUE(coupled->partner);
  EXPECT_EQ(coupled->text, "partner.MB 10");
  EXPECT_FALSE(control.resolver()("MB 10", at)->partner);
}

bool alarmBitsMissing(const std::string& listing) {
  project::Project project = project::load("a.s5", {}, {{"a.s5", listing}});
  project.control->plc.userAlarms.alarms = {.db = 30, .first = 1};
  const Build made = build(std::move(project), false);
  const bool missing =
      made.problems.size() == 1 && made.problems.list()[0].code == ProblemCode::P1153;
  EXPECT_NE(missing, made.ok());
  return missing;
}

// OP-55: 64 bits from DW 1 on take the words 1 to 4. FB 11 may make the block when the program
// runs.
TEST(AlarmBits, areWordsOfTheProgram) {
  const std::string four = "DB 30\n0 : KH = 0000\n1 : KH = 0000\n2 : KH = 0000\n3 : KH = 0000\n";
  EXPECT_TRUE(alarmBitsMissing("OB 1\nBE\n"));
  EXPECT_TRUE(alarmBitsMissing("OB 1\nBE\n" + four));
  EXPECT_FALSE(alarmBitsMissing("OB 1\nBE\n" + four + "4 : KH = 0000\n"));
  EXPECT_FALSE(
      alarmBitsMissing("OB 1\nSPA FB 11\nNAME : EINR-DB\nDBAN : KY 30,1\nDWNR : KF +5\nBE\n"));
}

TEST(Cancel, leavesNoBlockOfAListing) {
  std::stop_source source;
  project::Project project =
      project::load("a.s5", {}, {{"a.s5", "OB 1\nBE\n"}}, source.get_token());
  source.request_stop();
  const Build cancelled = build(std::move(project), false);
  EXPECT_FALSE(cancelled.ok());
  EXPECT_EQ(cancelled.blocks(), 0u);
}

}  // namespace
}  // namespace merker::compilation
