// The state of a CPU, taken over by another one (S7-SIM-13): from then on both do the same, each on
// its own clock.
#include <gtest/gtest.h>

#include "cpu/cpu.h"
#include "program.h"

namespace merker::station::test {
namespace {

const CpuModel& generic() { return *findCpuModel("generic"); }

// Timers of each kind, counters, all interrupts of time, a meter, what OB 1 learns of its cycles.
const std::string& program() {
  static const std::string kText =
      "DATA_BLOCK DB 1\nSTRUCT\n n : INT := 3;\n t : DATE_AND_TIME := "
      "DT#1990-01-01-00:00:10.000;\nEND_STRUCT;\n"
      "BEGIN\nEND_DATA_BLOCK\nDATA_BLOCK DB 2\nNON_RETAIN\nSTRUCT\n n : INT := "
      "4;\nEND_STRUCT;\nBEGIN\n"
      "END_DATA_BLOCK\n" +
      ob(100,
         "CALL SFC 28 (OB_NR := 10, SDT := DB1.t, PERIOD := W#16#0201, RET_VAL := MW 100);"
         "CALL SFC 30 (OB_NR := 10, RET_VAL := MW 100);"
         "CALL SFC 2 (NR := B#16#1, PV := 7, RET_VAL := MW 100);"
         "CALL SFC 3 (NR := B#16#1, S := TRUE, RET_VAL := MW 100);"
         "CALL SFC 32 (OB_NR := 20, DTIME := T#20S, SIGN := W#16#4711, RET_VAL := MW 100);"
         "CALL SFC 22 (LOW_LIMIT := W#16#9, UP_LIMIT := W#16#9, COUNT := W#16#4, RET_VAL := MW "
         "100, DB_NUMBER := MW 102);"
         "CALL SFC 39 (MODE := B#16#2, OB_NR := 36, RET_VAL := MW 100);"
         "L C#990; SET; S Z 2;") +
      ob(10, "L MW 44; + 1; T MW 44;") + ob(20, "L MW 40; + 1; T MW 40; L LW 6; T MW 48;") +
      ob(33, "L MW 42; + 1; T MW 42; AUF DB 9; T DBW 0;") + ob(36, "L MW 50; + 1; T MW 50;") +
      ob(1,
         "L MW 0; + 1; T MW 0; L DB1.n; + 1; T DB1.n; L DB2.n; + 1; T DB2.n;"
         "L LB 1; T MB 30; L LW 6; T MW 32; L LW 8; T MW 34; L LW 10; T MW 36;"
         "CALL SFC 64 (RET_VAL := MD 20); CALL SFC 4 (NR := B#16#1, RET_VAL := MW 100, CQ := M "
         "60.0, CV := MW 62);"
         "U E 0.0; L S5T#10S; SI T 1; U E 0.0; L S5T#11S; SV T 2; U E 0.0; L S5T#12S; SE T 3;"
         "U E 0.0; L S5T#13S; SS T 4; UN E 0.0; L S5T#14S; SA T 5; SET; L S5T#1M; SA T 6;"
         "U T 1; = M 70.1; U T 2; = M 70.2; U T 3; = M 70.3; U T 4; = M 70.4; U T 5; = M 70.5; U T "
         "6; = M 70.6;"
         "L T 1; T MW 80; L T 2; T MW 82; L T 3; T MW 84; L T 4; T MW 86; LC T 5; T MW 88; L T 6; "
         "T MW 90;"
         "U M 42.0; ZV Z 1; U M 43.0; ZV Z 1; U M 43.1; ZV Z 2; L Z 1; T MW 92; LC Z 2; T MW 94;"
         "U E 0.0; = A 0.0; U M 43.2; = A 1.1;");
  return kText;
}

CpuParameters parameters() {
  CpuParameters result = CpuParameters::of(generic());
  result.cyclic.push_back({.ob = 33, .interval = 500, .phase = 30});
  result.minimumCycle = 20;
  return result;
}

// All that the program shows, and what lies at the terminals.
std::vector<std::uint32_t> seen(Plc& plc) {
  std::vector<std::uint32_t> values;
  for (int byte = 0; byte < 104; byte += 4)
    values.push_back(plc.read("MD " + std::to_string(byte)));
  for (const char* operand : {"DB1.n", "DB2.n", "DB9.DBW 0", "PAB 0", "PAB 1", "EB 0"})
    values.push_back(plc.read(operand));
  values.push_back(static_cast<std::uint32_t>(plc->cpu().log().dateAndTime()[5]));
  return values;
}

std::shared_ptr<const block::Program> copied(Plc& plc) {
  return std::make_shared<const block::Program>(plc->program());
}

TEST(Snapshot, BothGoOnAlike) {
  Plc one(program(), generic(), parameters());
  one.start();
  one.run(Duration::milliseconds(5'000));
  one.write("E 0.0", 1);
  one.run(Duration::milliseconds(2'345));
  Plc other(program(), generic(), parameters());
  other->advanceTo(Instant{3'210'000'000});
  other->take(one->cpu().snapshot(), copied(one));
  EXPECT_EQ(other->mode(), Mode::Run);
  EXPECT_EQ(seen(one), seen(other));
  const Duration ahead = one->now() - other->now();
  for (int i = 1; i <= 300; ++i) {
    if (i == 150) one.write("E 0.0", 0), other.write("E 0.0", 0);
    one.run(Duration::milliseconds(250));
    other.run(Duration::milliseconds(250));
    ASSERT_EQ(seen(one), seen(other)) << i;
    ASSERT_EQ((one->now() - other->now()).ns, ahead.ns) << i;
  }
  EXPECT_GT(one.read("MW 44"), 0u);
  EXPECT_EQ(one.read("MW 40"), 1u);
  EXPECT_EQ(one.read("MW 48"), 0x4711u);
  EXPECT_EQ(one.read("MW 50"), 0u);  // locked, here and there
}

TEST(Snapshot, OfAStop) {
  Plc one(ob(1, "U E 0.0; SPBN M001; AUF DB 99; M001: L MW 0; + 1; T MW 0; L B#16#5; T PAB 3;"),
          generic());
  one.cycles(3);
  one->setSwitch(cpu::SwitchPosition::Run);
  one.write("E 0.0", 1);
  one.run(Duration::milliseconds(20));
  ASSERT_EQ(one->mode(), Mode::Stop);
  Plc other(ob(1, ""), generic());
  other.cycles(2);
  other->advanceTo(other->now() + Duration::seconds(9));
  other->take(one->cpu().snapshot(), copied(one));
  EXPECT_EQ(other->mode(), Mode::Stop);
  EXPECT_TRUE(other->stoppedByFault());
  EXPECT_EQ(other->stopReason(), one->stopReason());
  EXPECT_EQ(other->leds().sf, cpu::Light::On);
  EXPECT_EQ(other->switchPosition(), cpu::SwitchPosition::Run);
  EXPECT_EQ(other->diagnostics().size(), one->diagnostics().size());
  EXPECT_EQ(other->diagnostics().back().event, 0x4562u);
  EXPECT_EQ((other->now() - other->diagnostics().back().time).ns,
            (one->now() - one->diagnostics().back().time).ns);
  EXPECT_EQ(other.read("MW 0"), one.read("MW 0"));
  other->setSwitch(cpu::SwitchPosition::Stop);
  other.write("E 0.0", 0);
  other->setSwitch(cpu::SwitchPosition::RunP);
  other.run(Duration::milliseconds(20));
  EXPECT_EQ(other->mode(), Mode::Run);
  EXPECT_EQ(other.read("PAB 3"), 5u);
}

// A CPU that stood in STOP without fault has no reason to show, and one that runs ends the STOP of
// the other.
TEST(Snapshot, EndsWhatWasBefore) {
  Plc one(ob(1, "L MW 0; + 1; T MW 0;"), generic());
  one.cycles(3);
  Plc other(ob(1, "AUF DB 99;"), generic());
  other.cycles(1);
  ASSERT_TRUE(other->stoppedByFault());
  other->take(one->cpu().snapshot(), copied(one));
  EXPECT_EQ(other->mode(), Mode::Run);
  EXPECT_EQ(other->leds().sf, cpu::Light::Off);
  EXPECT_FALSE(other.hasEvent(0x4562));
  const unsigned before = other.read("MW 0");
  other->advanceCycles(2);
  EXPECT_EQ(other.read("MW 0"), before + 2);
}

}  // namespace
}  // namespace merker::station::test
