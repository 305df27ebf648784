// What FB 61 and FB 62 move, and the errors that are not of the data type.
#include "rig.h"

namespace merker::nc {
namespace {

Call reading(const char* type, std::array<int, 3> where, const char* format, int count = 1) {
  Call call;
  call.type = type;
  call.where = where;
  call.format = format;
  call.count = count;
  call.place = "10,0";
  return call;
}
Call writing(const char* type, std::array<int, 3> where, const char* format, int count = 1) {
  Call call = reading(type, where, format, count);
  call.macro = 62;
  return call;
}
// DW 0 … of DB 10 as 32-bit numbers.
std::int32_t number(Rig& rig, unsigned index) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(rig.word(10, 2 * index)) << 16 |
                                   rig.word(10, 2 * index + 1));
}
void setNumber(Rig& rig, unsigned index, std::int32_t value) {
  rig.word(10, 2 * index) = static_cast<std::uint16_t>(static_cast<std::uint32_t>(value) >> 16);
  rig.word(10, 2 * index + 1) = static_cast<std::uint16_t>(value);
}
std::int32_t readNumber(const Control& control, const Call& call, unsigned index = 0) {
  JobRig rig(call);
  rig.macros.control() = control;
  EXPECT_EQ(rig.run(), "");
  return number(rig, index);
}
Control written(const Call& call, std::int32_t value, const Control& before = {},
                const char* outcome = "") {
  JobRig rig(call);
  rig.macros.control() = before;
  setNumber(rig, 0, value);
  setNumber(rig, 1, value + 1);
  setNumber(rig, 2, value + 2);
  EXPECT_EQ(rig.run(), outcome);
  return rig.macros.control();
}

// S5-FM-42: machine data, setting data, their bytes.
TEST(Jobs, MachineAndSettingData) {
  Control c;
  c.machineData[4999] = -17;
  c.settingData[0] = 99'999'999;
  EXPECT_EQ(readNumber(c, reading("MDN", {4999, 0, 0}, "F0")), -17);
  EXPECT_EQ(readNumber(c, reading("SEN", {0, 0, 0}, "F0")), 99'999'999);
  EXPECT_EQ(written(writing("MDN", {100, 0, 0}, "F0", 3), 7).machineData[102], 9);
  EXPECT_EQ(written(writing("SEN", {100, 0, 0}, "F0"), 7).settingData[100], 7);
  c.machineDataBytes[0] = 0x81;
  JobRig bits(reading("MDNBY", {5000, 0, 0}, "BI"));
  bits.macros.control() = c;
  EXPECT_EQ(bits.run(), "");
  EXPECT_EQ(bits.word(10, 0), 0x81u);
  EXPECT_EQ(written(writing("SENBY", {9999, 0, 0}, "BI"), 0xA5 << 16).settingDataBytes[4999],
            0xA5u);
}

// S5-FM-42: tool offsets, additive ones, several parameters of one D number.
TEST(Jobs, ToolOffsets) {
  Control c;
  c.tools[98][2] = {12345, 2};
  c.tools[98][3] = {-5, 1};
  EXPECT_EQ(readNumber(c, reading("TOS", {0, 99, 2}, "F4", 2), 0), 123450);
  EXPECT_EQ(readNumber(c, reading("TOS", {0, 99, 2}, "F4", 2), 1), -500);
  EXPECT_EQ(written(writing("TOS", {0, 1, 15}, "F4"), 1500).tools[0][15], (Number{1500, 3}));
  EXPECT_EQ(written(writing("TOA", {99, 2, 0}, "F2"), -5, c).tools[98][2], (Number{12295, 2}));
  c.tools[98][2] = {kMostDigits, 0};
  const Control full = written(writing("TOA", {99, 2, 0}, "F0"), 1, c, "FEHLER");
  EXPECT_EQ(full.tools[98][2].digits, kMostDigits);
  EXPECT_EQ(full.alarms, std::vector<std::uint16_t>{3016});
}

// S5-FM-42: zero offsets and their sum, actual positions.
TEST(Jobs, ZeroOffsetsAndPositions) {
  Control c;
  c = written(writing("ZOA", {2, 3, 0}, "F4"), 10'000, c);
  c = written(writing("ZOA", {2, 3, 1}, "F4"), 5, c);
  c = written(writing("ZOFA", {2, 3, 1}, "F4"), -2, c);
  c = written(writing("ZOPR", {1, 3, 0}, "F3"), 200, c);
  c = written(writing("ZOPR", {2, 3, 0}, "F1"), 3, c);
  c = written(writing("ZOE", {3, 0, 0}, "F0"), 40'000, c);
  c = written(writing("ZOPS", {3, 0, 0}, "F4"), 500'000, c);
  c.axes[2].position = 1'000'000;
  EXPECT_EQ(c.settable[1][2].coarse, 10'000);
  EXPECT_EQ(readNumber(c, reading("ZOA", {2, 3, 1}, "F4")), 3);
  EXPECT_EQ(readNumber(c, reading("ZOPR", {1, 3, 0}, "F4")), 2'000);
  EXPECT_EQ(readNumber(c, reading("ZOS", {3, 0, 0}, "F0")), 545'000);  // G54 in force
  c.channels[0].settableGroup = 2;
  EXPECT_EQ(readNumber(c, reading("ZOS", {3, 0, 0}, "F0")), 555'003);
  EXPECT_EQ(readNumber(c, reading("ACPM", {3, 0, 0}, "F0")), 1'000'000);
  EXPECT_EQ(readNumber(c, reading("ACPW", {3, 0, 0}, "F0")), 444'997);
  c.inputSystem = InputSystem::Inch;  // 0.0001 inch
  EXPECT_EQ(readNumber(c, reading("ZOE", {3, 0, 0}, "F4")), 4'000);
}

// S5-FM-42: external feed, selection of a program.
TEST(Jobs, FeedAndProgramSelection) {
  const Control feed = written(writing("EXBF", {2, 1, 0}, "F4"), 1500);
  EXPECT_EQ(feed.channels[1].externalFeed[1], (Number{1500, 3}));
  EXPECT_EQ(readNumber(feed, reading("EXBF", {2, 1, 0}, "F4")), 1500);
  written(writing("EXBF", {2, 1, 0}, "F4"), -1, {}, "FEHLER");
  const Control main = written(writing("INITMP", {2, 0, 0}, "F0"), 9999);
  EXPECT_EQ(main.channels[1].pointers[0].values, (std::array<std::int32_t, 3>{1, 9999, 0}));
  const Control sub = written(writing("INITSP", {1, 0, 0}, "F0"), 12);
  EXPECT_EQ(sub.channels[0].pointers[0].values, (std::array<std::int32_t, 3>{2, 12, 0}));
  written(writing("INITMP", {1, 0, 0}, "F0"), 10'000, {}, "FEHLER");
  written(writing("INITMP", {1, 0, 0}, "F0"), 0, {}, "FEHLER");
}

// S5-FM-43: one program pointer is three values.
TEST(Jobs, ProgramPointer) {
  Control c;
  c.channels[0].pointers[0].values = {1, 100, 40};
  c.channels[0].pointers[3].values = {7, 2, 99'999};
  for (unsigned i = 0; i < 3; ++i) {
    EXPECT_EQ(readNumber(c, reading("PP", {1, 0, 0}, "F0"), i),
              c.channels[0].pointers[0].values[i]);
    EXPECT_EQ(readNumber(c, reading("PP", {1, 3, 0}, "F0"), i),
              c.channels[0].pointers[3].values[i]);
  }
}

// S5-FM-42: NC alarms, 0 behind the last.
TEST(Jobs, Alarms) {
  Control c;
  c.raise(3016);
  c.raise(2000);
  c.raise(3016);
  EXPECT_EQ(readNumber(c, reading("NCAL", {0, 0, 0}, "F0", 3), 1), 2000);
  EXPECT_EQ(readNumber(c, reading("NCAL", {0, 0, 0}, "F0", 3), 2), 0);
}

// S5-FM-28: three values, nothing behind them; the NC must have them all.
TEST(Jobs, SeveralValues) {
  Control c;
  for (std::uint8_t i = 0; i < 3; ++i) c.centralParameters[97 + i] = {i + 5, 0};
  JobRig rig(reading("RPNC", {0, 997, 0}, "F0", 3));
  rig.macros.control() = c;
  rig.word(10, 6) = 0x1234;
  EXPECT_EQ(rig.run(), "");
  for (unsigned i = 0; i < 3; ++i) EXPECT_EQ(number(rig, i), static_cast<int>(i + 5));
  EXPECT_EQ(rig.word(10, 6), 0x1234u);
  JobRig beyond(reading("RPNC", {0, 998, 0}, "F0", 3));
  beyond.macros.control() = c;
  EXPECT_EQ(beyond.run(), "FEHLER");
  EXPECT_EQ(number(beyond, 0), 0);
  EXPECT_TRUE(beyond.macros.control().alarms.empty());
}

// S5-FM-35: a value that the NC does not take is its alarm; the PLC runs on.
TEST(Jobs, WrongValueIsAnAlarmOfTheNc) {
  const Call call = writing("RPNC", {1, 50, 0}, "F0");
  EXPECT_EQ(written(call, 99'999'999).parameters[0][50].digits, 99'999'999);
  const Control c = written(call, 100'000'000, {}, "FEHLER");
  EXPECT_EQ(c.alarms, std::vector<std::uint16_t>{3016});
  EXPECT_EQ(c.parameters[0][50], Number{});
}

// S5-FM-40: a digit that is neither 0 nor 1 stops the PLC when the job is done.
TEST(Jobs, BitPatternOfOtherDigits) {
  JobRig rig(reading("RPNC", {1, 100, 0}, "BI"));
  rig.macros.control().parameters[0][100] = {10111020, 0};
  EXPECT_EQ(rig.run(), "61/262");
  JobRig good(reading("RPNC", {1, 100, 0}, "BI"));
  good.macros.control().parameters[0][100] = {10111010, 0};
  EXPECT_EQ(good.run(), "");
  EXPECT_EQ(good.word(10, 0), 0xBAu);
}

// S5-FM-37: the free byte stays, in data and in flags.
TEST(Jobs, BcdInFlags) {
  Call call = reading("RPNC", {1, 50, 0}, "B4");
  call.place = "0,160";
  JobRig rig(call);
  rig.macros.control().parameters[0][50] = {-87654321, 3};
  rig.setFlagWord(160, 0xAAAA);
  EXPECT_EQ(rig.run(), "");
  EXPECT_EQ(rig.flagWord(160), 0xAA18u);
  EXPECT_EQ(rig.flagWord(162), 0x7654u);
  EXPECT_EQ(rig.flagWord(164), 0xE321u);
}

std::string placed(const char* place, int count, unsigned macro = 61) {
  Call call = reading("RPNC", {1, 50, 0}, "F0", count);
  call.macro = macro;
  call.place = place;
  Rig rig;
  rig.options.dataInEprom.set(11);
  EXPECT_TRUE(rig.start(dataBlock(11, 10) + cyclic(call.text())));
  rig.machine().flags[100] = 1;
  rig.cycles(3);
  return rig.stop();
}

// S5-FM-28, S5-FM-32, S5-FM-34: error 2.
TEST(Jobs, PlaceInThePlc) {
  EXPECT_EQ(placed("10,0", 20), "");
  EXPECT_EQ(placed("10,0", 21), "61/258");
  EXPECT_EQ(placed("10,39", 1), "61/258");
  EXPECT_EQ(placed("12,0", 1), "61/258");
  EXPECT_EQ(placed("1,0", 1), "61/258");
  EXPECT_EQ(placed("0,135", 1), "61/258");
  EXPECT_EQ(placed("0,136", 30), "");
  EXPECT_EQ(placed("0,136", 31), "61/258");
  EXPECT_EQ(placed("0,253", 1), "61/258");
  EXPECT_EQ(placed("11,0", 1), "61/258");  // in the EPROM
  EXPECT_EQ(placed("11,0", 1, 62), "");
  EXPECT_EQ(placed("12,0", 1, 62), "62/258");
}

// S5-FM-23, S5-FM-34: without the option error 8, no interface byte with it.
TEST(Jobs, OptionOff) {
  MacroOptions off;
  off.exchange.enabled = false;
  JobRig rig(reading("RPNC", {1, 50, 0}, "F0"), off);
  rig.cycles(1);
  EXPECT_EQ(rig.stop(), "61/8");
}

// S5-FM-27, S5-FM-34: error 1 for what is no byte of the interface.
TEST(Jobs, InterfaceBytes) {
  const struct {
    const char* byte;
    const char* outcome;
    unsigned number;
  } rows[] = {{"DL 0", "", 1},   {"DR 0", "", 2},      {"DL 15", "", 31},    {"DR 31", "", 64},
              {"DL 32", "", 65}, {"DR 32", "61/1", 0}, {"DL 33", "61/1", 0}, {"MB 242", "61/1", 0}};
  for (const auto& row : rows) {
    Call call = reading("RPNC", {1, 50, 0}, "F0");
    call.byte = row.byte;
    Rig rig;
    ASSERT_TRUE(rig.start(cyclic(call.text())));
    rig.machine().flags[100] = 1;
    rig.cycles(3);
    EXPECT_EQ(rig.stop(), row.outcome) << row.byte;
    if (row.number != 0) {
      EXPECT_EQ(rig.interfaceByte(row.number), 0x10u) << row.byte;
    }
  }
}

// S5-FM-34: the number of the interface byte stands in the high byte of AKKU 2.
TEST(Jobs, ErrorWithInterfaceByte) {
  Call call = reading("XX", {1, 50, 0}, "F0");
  call.byte = "DL 15";
  JobRig rig(call);
  EXPECT_EQ(rig.run(), "61/" + std::to_string(31 * 256 + 3));
}

}  // namespace
}  // namespace merker::nc
