// Variable tables and forces of a programming device (S7-SIM-12), in bytes.
#include "served/bench.h"

#include "cpu/led_panel.h"
#include "served/flash_task.h"
#include "test_line.h"

namespace merker::served {
namespace {

constexpr unsigned kStatus = 0x02, kModify = 0x08, kForce = 0x09, kDisable = 0x0D, kEnable = 0x0E,
                   kDelete = 0x0F, kList = 0x10, kRead = 0x11, kReplace = 0x12, kFlash = 0x16;
constexpr unsigned kNow = 0, kBegin = 2, kEnd = 3, kStop = 4;

constexpr std::string_view kCounters = "00 01 02 01 00 00 00 0A";  // MW 10

class TestBench : public ::testing::Test {
 protected:
  TestBench() { plc.cycles(1); }
  ServedPlc plc = ServedPlc::station();
  TestLine line{plc};
};

TEST_F(TestBench, aStatusAtOnce) {
  EXPECT_EQ(line.ask(kStatus, words(0, 1, kNow), kCounters),
            "answer 02 01 00 00 | says 02 01 00 00: 00 01 FF 09 00 02 02 02");
  plc.cycles(2);
  EXPECT_EQ(line.heard(), "");
  EXPECT_EQ(line.ask(kEnable, words(0, 1, 0), "02 01"), "answer 0E 02 D0 A5");
}

TEST_F(TestBench, areasWidthsAndWhatIsNotThere) {
  plc.writeNow(flags(100, 4), {1, 2, 3, 4});
  EXPECT_EQ(
      line.ask(kStatus, words(0, 1, kNow),
               "00 08 01 03 00 00 00 64 02 01 00 00 00 64 03 01 00 00 00 64 00 01 00 00 00 65 "
               "72 01 00 05 00 00 71 01 00 06 00 00 01 01 00 00 FF FF 91 01 00 00 00 00"),
      "answer 02 01 00 00 | says 02 01 00 00: 00 08 FF 09 00 03 01 02 03 00 FF 09 00 02 01 02 "
      "FF 09 00 04 01 02 03 04 FF 09 00 01 01 00 FF 09 00 02 01 02 0A 00 00 00 05 00 00 00 "
      "06 00 00 00");
}

TEST_F(TestBench, aPermanentStatusIsToldOnceEachTimeItIsEnabled) {
  EXPECT_EQ(line.ask(kStatus, words(1, 0, kEnd), kCounters), "answer 02 01 00 00");
  plc.cycles(3);
  EXPECT_EQ(line.heard(), "");
  EXPECT_EQ(line.ask(kEnable, words(0, 1, 0), "02 01"), "answer 0E 02 00 00");
  plc.cycles(3);
  EXPECT_EQ(line.heard(), "says 02 01 00 00: 00 01 FF 09 00 02 07 07");
  EXPECT_EQ(line.ask(kEnable, words(0, 1, 0), "02 01"), "answer 0E 03 00 00");
  EXPECT_EQ(line.ask(kDelete, words(0, 1, 0), "00 01 02 01"),
            "answer 0F 04 00 00 | says 02 01 00 00: 00 01 FF 09 00 02 0B 0B");
  EXPECT_EQ(line.ask(kDelete, words(0, 1, 0), "00 01 02 01"), "answer 0F 05 D0 A5");
}

// Before OB 1 MB 10 is what the last cycle left.
TEST_F(TestBench, atTheBeginOfACycle) {
  plc.writeNow(flags(11, 1), {77});
  line.ask(kStatus, words(1, 0, kBegin), kCounters);
  line.send(kEnable, words(0, 1, 0), "02 01");
  plc.cycles(1);
  line.heard();
  plc.cycles(1);
  EXPECT_EQ(line.heard(), "says 02 01 00 00: 00 01 FF 09 00 02 04 04");
}

TEST_F(TestBench, atTheTransitionToStopAndInStop) {
  line.ask(kStatus, words(1, 0, kStop), kCounters);
  line.ask(kEnable, words(0, 1, 0), "02 01");
  plc.cycles(2);
  EXPECT_EQ(line.heard(), "");
  plc.plc().stop();
  plc.look();
  EXPECT_EQ(line.heard(), "says 02 01 00 00: 00 01 FF 09 00 02 05 05");
  line.send(kStatus, words(1, 0, kEnd), kCounters);
  line.send(kEnable, words(0, 1, 0), "02 03");
  plc.look();
  plc.look();
  EXPECT_EQ(line.heard(),
            "answer 02 03 00 00 | answer 0E 04 00 00 | says 02 03 00 00: 00 01 FF 09 00 02 05 05");
}

TEST_F(TestBench, modifiesAtOnce) {
  EXPECT_EQ(line.ask(kModify, words(0, 1, kNow),
                     "00 02 01 01 00 00 00 78 71 01 00 07 00 00 00 09 00 01 55 00 00 09 00 01 66"),
            "answer 08 01 00 00 | says 08 01 00 00: 00 02 FF 0A");
  EXPECT_EQ(plc.read(flags(120, 1))->octets, Bytes{0x55});
}

// In each cycle, behind OB 1; the client hears of it once.
TEST_F(TestBench, modifiesPermanently) {
  EXPECT_EQ(line.ask(kModify, words(2, 0, kEnd), "00 01 01 01 00 00 00 0A 00 09 00 01 64 00"),
            "answer 08 01 00 00");
  plc.cycles(1);
  EXPECT_EQ(line.heard(), "says 08 01 00 00: 00 01 FF 00");
  plc.cycles(2);
  EXPECT_EQ(line.heard(), "");
  EXPECT_EQ(plc.read(flags(10, 2))->octets, (Bytes{0x64, 0x65}));
  line.ask(kDelete, words(0, 1, 0), "00 01 08 01");
  plc.cycles(2);
  EXPECT_EQ(plc.read(flags(10, 1))->octets, Bytes{0x66});
}

// A job that is disabled does nothing; read and replaced.
TEST_F(TestBench, jobsAreDisabledListedReadAndReplaced) {
  const std::string parameters = words(2, 0, kEnd);
  line.ask(kModify, parameters, "00 01 01 01 00 00 00 78 00 09 00 01 64 00");
  EXPECT_EQ(line.ask(kList, words(0, 1, 0), "00 00 00 00").substr(0, 31),
            "answer 10 02 00 00: 08 01 01 00");
  line.ask(kDisable, words(0, 1, 0), "08 01");
  plc.writeNow(flags(120, 1), {1});
  plc.cycles(1);
  EXPECT_EQ(plc.read(flags(120, 1))->octets, Bytes{1});
  line.heard();
  EXPECT_EQ(line.ask(kList, words(0, 1, 0), "00 00 00 00"), "answer 10 04 00 00: 08 01 00 00");
  EXPECT_EQ(line.ask(kRead, words(0, 1, 0), "08 01"),
            "answer 11 05 00 00: 00 14 00 0E " + parameters +
                " 00 01 01 01 00 00 00 78 00 09 00 01 64 00");
  EXPECT_EQ(line.ask(kReplace, words(0, 1, 0),
                     "00 00 08 01 00 14 00 0E " + parameters +
                         " 00 01 01 01 00 00 00 79 00 09 00 01 33 00"),
            "answer 12 06 00 00");
  plc.cycles(1);
  EXPECT_EQ(plc.read(flags(120, 2))->octets, (Bytes{1, 0x33}));
}

const std::string kForceNow = "00 00 01 00 00 02 00 04 00 01 00 01 00 01 00 01 00 01 00 00";

// As a programming device does it: A 2.1 and A 2.2.
TEST_F(TestBench, forcesAndShowsWhatIsForced) {
  const std::string two =
      "00 02 20 01 00 00 00 02 20 02 00 00 00 02 00 09 00 01 01 00 00 09 00 01 00 00";
  EXPECT_EQ(line.ask(kForce, kForceNow, two), "answer 09 01 00 00 | says 09 01 00 00: 00 02 FF FF");
  ASSERT_EQ(plc.monitor().forces().size(), 2u);
  EXPECT_EQ(plc.monitor().forces()[0].operand.text, "A 2.1");
  EXPECT_EQ(plc.monitor().forces()[0].value, 1u);
  EXPECT_EQ(line.ask(kForce, kForceNow, two), "answer 09 02 D0 A4");
  EXPECT_EQ(line.ask(kList, words(0, 1, 0), "00 00 00 00"), "answer 10 03 00 00: 09 01 01 00");
  EXPECT_EQ(line.ask(kRead, words(0, 1, 0), "09 01"),
            "answer 11 04 00 00: 00 14 00 1A " + kForceNow + " " + two);
  EXPECT_EQ(line.ask(kReplace, words(0, 1, 0),
                     "00 00 09 01 00 14 00 0E " + kForceNow +
                         " 00 01 11 01 00 00 00 00 00 09 00 01 0F 00"),
            "answer 12 05 00 00");
  ASSERT_EQ(plc.monitor().forces().size(), 1u);
  EXPECT_EQ(line.ask(kEnable, words(0, 1, 0), "09 01"), "answer 0E 06 D0 A6");
  EXPECT_EQ(line.ask(kDelete, words(0, 1, 0), "00 01 09 01"), "answer 0F 07 00 00");
  EXPECT_TRUE(plc.monitor().forces().empty());
}

// An S7-300 forces E and A alone; nothing of the job then.
TEST_F(TestBench, whatCannotBeForcedRefusesAll) {
  EXPECT_EQ(
      line.ask(kForce, kForceNow,
               "00 02 21 01 00 00 00 02 01 01 00 00 00 02 00 09 00 01 01 00 00 09 00 01 00 00"),
      "answer 09 01 D0 42");
  EXPECT_TRUE(plc.monitor().forces().empty());
}

// What the workbench forces is a job as well, and it stays when its programming device goes.
TEST_F(TestBench, forcesOfOthers) {
  plc.monitor().force("E 1.3", "1");
  EXPECT_EQ(line.ask(kList, words(0, 1, 0), "00 00 00 00"), "answer 10 01 00 00: 09 02 01 00");
  {
    TestLine other(plc);
    EXPECT_EQ(other.ask(kDelete, words(0, 1, 0), "00 01 09 02"), "answer 0F 03 00 00");
    EXPECT_EQ(other.ask(kForce, kForceNow, "00 01 11 01 00 00 00 00 00 09 00 01 0F 00"),
              "answer 09 04 00 00 | says 09 04 00 00: 00 01 FF 00");
  }
  plc.cycles(2);
  EXPECT_EQ(plc.monitor().forces().size(), 1u);
  EXPECT_EQ(line.ask(kList, words(0, 1, 0), "00 00 00 00"), "answer 10 05 00 00: 09 04 01 00");
}

TEST_F(TestBench, jobsOfOthersAndOfThoseWhoHaveGone) {
  {
    TestLine other(plc);
    other.ask(kStatus, words(1, 0, kEnd), kCounters);
    EXPECT_EQ(line.ask(kEnable, words(0, 1, 0), "02 01"), "answer 0E 02 D0 AE");
  }
  plc.cycles(1);
  EXPECT_EQ(line.ask(kEnable, words(0, 1, 0), "02 01"), "answer 0E 03 D0 A5");
  EXPECT_EQ(line.ask(kList, words(0, 1, 0), "00 00 00 00"), "answer 10 04 00 00");
}

// A recorded conversation has the numbers of another CPU.
TEST_F(TestBench, anotherNumberIsTheLastJobOfThatFunction) {
  line.ask(kStatus, words(1, 0, kEnd), kCounters);
  line.ask(kStatus, words(1, 0, kEnd), "00 01 01 01 00 00 00 0A");
  EXPECT_EQ(line.ask(kEnable, words(0, 1, 0), "02 77"), "answer 0E 03 00 00");
  plc.cycles(2);
  EXPECT_TRUE(line.heard().starts_with("says 02 02 00 00"));
  EXPECT_EQ(line.ask(kEnable, words(0, 1, 0), "08 77"), "answer 0E 04 D0 A5");
}

TEST_F(TestBench, limits) {
  EXPECT_EQ(line.ask(kStatus, words(1, 0, kEnd), "00 01 01 C8 00 00 00 00"), "answer 02 01 00 00");
  EXPECT_EQ(line.ask(kStatus, words(1, 0, kEnd), "00 01 01 C9 00 00 00 00"), "answer 02 02 D0 64");
  EXPECT_EQ(line.ask(kStatus, words(1, 0, 5), kCounters), "answer 02 03 D0 0A");
  for (int i = 0; i < 7; ++i)
    EXPECT_TRUE(line.ask(kStatus, words(1, 0, kEnd), kCounters).ends_with("00 00"));
  EXPECT_EQ(line.ask(kStatus, words(1, 0, kEnd), kCounters), "answer 02 0B D0 62");
  EXPECT_EQ(line.ask(kStatus, words(0, 0, 0), "00 00"), "answer 02 00 D0 5F");
  EXPECT_EQ(line.ask(kStatus, words(0, 0, 0), "00 02 01 01 00 00 00 00"), "answer 02 00 D0 33");
  EXPECT_EQ(line.ask(kStatus, "00 00", kCounters), "answer 02 00 D0 33");
  EXPECT_EQ(line.ask(kModify, words(0, 0, 0), "00 01 02 01 00 00 00 00 00 09 00 01 0F 00"),
            "answer 08 00 D0 44");
  EXPECT_EQ(line.ask(0x06, words(0, 0, 0), ""), "answer 06 0C D0 03");
}

// FRCE flashes until the job is deleted or its connection ends, at most ten seconds.
TEST_F(TestBench, anLedFlashes) {
  const auto frce = [&] { return controller::capability<cpu::LedPanel>(plc.plc())->leds().frce; };
  EXPECT_EQ(line.ask(kFlash, words(0, 0, 0), ""), "answer 16 01 00 00");
  plc.cycles(1);
  EXPECT_EQ(frce(), cpu::Light::Fast);
  EXPECT_EQ(line.ask(kDelete, words(0, 1, 0), "00 01 16 01"), "answer 0F 02 00 00");
  EXPECT_EQ(frce(), cpu::Light::Off);
  EXPECT_EQ(line.ask(kFlash, "", ""), "answer 16 03 00 00");
  plc.cycles(2);
  EXPECT_EQ(frce(), cpu::Light::Fast);
  plc.plc().advanceTo(plc.plc().now() + FlashTask::kLength);
  EXPECT_EQ(frce(), cpu::Light::Off);
}

}  // namespace
}  // namespace merker::served
