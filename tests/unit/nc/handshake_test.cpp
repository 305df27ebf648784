// The FIFO and the signals in DB 36 (6.3 FB 61/62 sections 4, 5, 8a, 8b).
#include "rig.h"

namespace merker::nc {
namespace {

// Bits of an interface byte as HandshakeBits orders them (OP-15).
constexpr unsigned kRequested = 1, kFull = 2, kRunning = 4, kBusy = 8, kDone = 16;

struct Machine : Rig {
  using Rig::Rig;
  void signal(bool on) { machine().flags[100] = on ? 1 : 0; }
};

// Signals of byte n every 5 ms, changes only.
std::vector<unsigned> watch(Rig& rig, unsigned n, int milliseconds) {
  std::vector<unsigned> seen;
  for (int t = 0; t < milliseconds; t += 5) {
    rig.milliseconds(5);
    const unsigned now = rig.interfaceByte(n);
    if (seen.empty() || seen.back() != now) seen.push_back(now);
  }
  return seen;
}

// S5-FM-44: absolute call, the user resets the signal at the end.
TEST(Handshake, AbsoluteCall) {
  Machine rig;
  ASSERT_TRUE(rig.start(cyclic(Call{}.text())));
  rig.cycles(1);
  EXPECT_EQ(rig.interfaceByte(1), 0u);
  rig.signal(true);
  EXPECT_EQ(watch(rig, 1, 400),
            (std::vector<unsigned>{0, kRequested | kBusy, kRequested | kBusy | kRunning, kDone}));
  rig.signal(false);
  EXPECT_EQ(watch(rig, 1, 100), (std::vector<unsigned>{kDone, 0}));
}

// In HALT a job stands, too, and takes the rest of its time afterwards.
TEST(Handshake, AJobStandsInHalt) {
  Machine rig;
  ASSERT_TRUE(rig.start(cyclic(Call{}.text())));
  rig.cycles(1);
  rig.signal(true);
  rig.milliseconds(61);
  ASSERT_EQ(rig.interfaceByte(1), kRequested | kBusy);
  EXPECT_TRUE(rig.plc->hold());
  EXPECT_EQ(watch(rig, 1, 1000), std::vector<unsigned>{kRequested | kBusy});
  EXPECT_TRUE(rig.plc->resume());
  rig.milliseconds(15);
  EXPECT_EQ(rig.interfaceByte(1), kRequested | kBusy);
  EXPECT_EQ(watch(rig, 1, 100), (std::vector<unsigned>{kRequested | kBusy | kRunning, kDone}));
}

// S5-FM-25, S5-FM-26: the signal that stays is one job; busy bytes take no second one.
TEST(Handshake, OneJobForOneSignal) {
  Machine rig;
  Call call;
  call.macro = 62;
  call.type = "TOA";
  call.where = {1, 2, 0};
  ASSERT_TRUE(rig.start(cyclic(call.text() + call.text())));
  rig.setFlagWord(162, 5);
  rig.signal(true);
  rig.cycles(8);
  EXPECT_EQ(rig.macros.control().tools[0][2], (Number{5, 0}));
  rig.signal(false);
  rig.cycles(1);
  rig.signal(true);
  rig.cycles(4);
  EXPECT_EQ(rig.macros.control().tools[0][2], (Number{10, 0}));
}

// S5-FM-25, S5-FM-45: SPB in one cycle with M 0.1.
TEST(Handshake, ConditionalCall) {
  Machine rig;
  Call call;
  call.macro = 62;
  call.signal = "M 0.1";
  call.type = "TOA";
  call.where = {1, 2, 0};
  ASSERT_TRUE(rig.start(cyclic(":U M 100.0\n" + call.text("SPB") + ":U M 0.1\n:R M 100.0\n")));
  rig.setFlagWord(162, 5);
  for (int i = 1; i <= 2; ++i) {
    rig.signal(true);
    rig.cycles(5);
    EXPECT_EQ(rig.interfaceByte(1), kDone);
    EXPECT_EQ(rig.macros.control().tools[0][2].digits, 5 * i);
  }
}

std::string jobs(unsigned count) {
  std::string text;
  for (unsigned i = 0; i < count; ++i) {
    Call call;
    call.byte = (i % 2 == 0 ? "DL " : "DR ") + std::to_string(i / 2);
    call.where[1] = static_cast<int>(i);
    call.place = "10," + std::to_string(2 * i);
    text += call.text();
  }
  return text;
}

// S5-FM-44: the FIFO without room says so; the job goes in as soon as there is some.
TEST(Handshake, FullFifo) {
  MacroOptions options;
  options.exchange.capacity = 2;
  Machine rig(options);
  for (std::uint8_t i = 0; i < 4; ++i) rig.macros.control().parameters[0][i] = {i + 1, 0};
  ASSERT_TRUE(rig.start(cyclic(jobs(4))));
  rig.cycles(1);
  rig.signal(true);
  const auto third = watch(rig, 3, 600);
  EXPECT_EQ(third, (std::vector<unsigned>{0, kRequested | kFull, kRequested | kBusy,
                                          kRequested | kBusy | kRunning, kDone}));
  for (unsigned i = 0; i < 4; ++i) EXPECT_EQ(rig.word(10, 2 * i + 1), i + 1);
}

// S5-FM-27: byte 65 overtakes all that wait, with all its values.
TEST(Handshake, AlarmJobOvertakes) {
  Machine rig;
  Call urgent;
  urgent.byte = "DL 32";
  urgent.count = 3;
  urgent.where[1] = 10;
  urgent.place = "10,20";
  for (std::uint8_t i = 0; i < 13; ++i) rig.macros.control().parameters[0][i] = {i + 1, 0};
  ASSERT_TRUE(rig.start(cyclic(jobs(3) + urgent.text())));
  rig.cycles(1);
  rig.signal(true);
  while (rig.word(10, 21) == 0) rig.milliseconds(5);
  for (unsigned i = 0; i < 3; ++i) EXPECT_EQ(rig.word(10, 21 + 2 * i), 11 + i);
  EXPECT_EQ(rig.word(10, 1), 0u);  // taken before, and not yet done
  rig.cycles(3);
  for (unsigned i = 0; i < 3; ++i) EXPECT_EQ(rig.word(10, 2 * i + 1), i + 1);
}

// S5-FM-29, S5-FM-30: the same job by flags, its byte by number and by code.
TEST(Handshake, VariableSupply) {
  const struct {
    int count;
    const char* byte;
  } rows[] = {{0, ":L KB 31\n:T MB 242\n"}, {128, ":L KH 220F\n:T MW 241\n"}};
  for (const auto& row : rows) {
    Machine rig;
    Call call;
    call.byte = "MB 242";
    call.count = row.count;
    call.where = {9, 9, 9};
    call.format = "00";
    call.place = "0,0";
    const std::string supply = std::string(row.byte) +
                               ":L KB 2\n:T MB 243\n:L KF +1\n:T MW 244\n:L KF +50\n:T MW 248\n"
                               ":L KF +0\n:T MW 250\n:L KC F1\n:T MW 252\n:L KY 10,4\n:T MW 254\n";
    rig.macros.control().parameters[0][50] = {25, 0};
    rig.macros.control().parameters[0][51] = {26, 0};
    ASSERT_TRUE(rig.start(cyclic(supply + call.text())));
    rig.signal(true);
    rig.cycles(3);
    EXPECT_EQ(rig.interfaceByte(31), kDone);
    EXPECT_EQ(rig.word(10, 5), 25u);
    EXPECT_EQ(rig.word(10, 7), 26u);
  }
}

// S5-FM-30, S5-FM-34: numbers in MB 242 and MB 243 that are none.
TEST(Handshake, VariableSupplyErrors) {
  const auto stopOf = [](unsigned byte, unsigned count) {
    Machine rig;
    Call call;
    call.count = 0;
    EXPECT_TRUE(rig.start(cyclic(call.text())));
    rig.machine().flags[242] = static_cast<std::uint8_t>(byte);
    rig.machine().flags[243] = static_cast<std::uint8_t>(count);
    rig.setFlagWord(244, 1);
    rig.setFlagWord(252, 0x4630);
    rig.setFlagWord(254, 0x0A00);
    rig.signal(true);
    rig.cycles(3);
    return rig.stop();
  };
  EXPECT_EQ(stopOf(65, 1), "");
  EXPECT_EQ(stopOf(0, 1), "61/1");
  EXPECT_EQ(stopOf(66, 1), "61/1");
  EXPECT_EQ(stopOf(2, 0), "61/516");
  EXPECT_EQ(stopOf(2, 81), "61/516");
}

// S5-FM-44: a start begins without jobs and with empty interface bytes.
TEST(Handshake, StopAndStart) {
  Machine rig;
  ASSERT_TRUE(rig.start(cyclic(Call{}.text())));
  rig.signal(true);
  rig.cycles(1);
  EXPECT_EQ(rig.interfaceByte(1) & kBusy, kBusy);
  rig.plc->stop();
  rig.plc->coldStart();
  rig.cycles(4);
  EXPECT_EQ(rig.interfaceByte(1), 0u);
  EXPECT_EQ(rig.macros.next(), Instant::never());
}

}  // namespace
}  // namespace merker::nc
