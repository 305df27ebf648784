// PLC machine data (chapter 7).
#include "softplc/machine_data.h"

#include "listing_bench.h"

namespace merker::sinumerik {
namespace {

constexpr const char* kOb1 = "OB 1\n BE\n";

// S5-MD-01, S5-ERR-17: each word has a highest value and its own alarm.
TEST(MachineData, LimitsOfTheWords) {
  struct Limit {
    unsigned number, standard, highest;
    Alarm alarm;
  };
  for (const Limit& l :
       {Limit{0, 7, 31, Alarm::AlarmByteNumber}, Limit{1, 15, 20, Alarm::LoadNumber},
        Limit{3, 2000, 2500, Alarm::AlarmTimeNumber}, Limit{5, 70, 320, Alarm::CycleTimeNumber},
        Limit{6, 15, 31, Alarm::LastTimerNumber}}) {
    EXPECT_EQ(MachineData().word(l.number), l.standard);
    for (const unsigned above : {0u, 1u}) {
      ListingBench b(kOb1);
      b.data().setWord(l.number, static_cast<std::uint16_t>(l.highest + above));
      b.run(70);
      if (above == 0)
        EXPECT_EQ(b.plc().mode(), Mode::Run) << l.number;
      else
        EXPECT_TRUE(b.stopped(l.alarm)) << l.number;
    }
  }
  EXPECT_EQ(MachineData().word(8), 1);
  EXPECT_EQ(MachineData().word(9), 8);
  EXPECT_FALSE(MachineData().setWord(10, 1));
  EXPECT_FALSE(MachineData().setWord(4, 1));
}

// S5-MD-02: MD 6 counts from the next start on.
TEST(MachineData, LastTimer) {
  ListingBench b("OB 1\n U M 0.1\n L KT 10.1\n SE T 16\n BE\n");
  b.run(70);
  EXPECT_TRUE(b.stopped(Alarm::TimerCounter));
  EXPECT_EQ(b.address(0xF004), 0x16u);
  b.plc().machineData().setWord(6, 31);
  EXPECT_TRUE(b.plc().coldStart());
  b.runTo(2000);
  EXPECT_EQ(b.plc().mode(), Mode::Run);
  EXPECT_EQ(b.value("T 16.0"), 1u);
  b.plc().machineData().setWord(6, 15);  // not taken over yet
  b.runTo(3000);
  EXPECT_EQ(b.plc().mode(), Mode::Run);
}

// S5-MD-03, S5-MD-04: 88 bits; the standard setting of MD 2003 is STOP, all functions off.
TEST(MachineData, Bits) {
  MachineData data;
  for (unsigned number = 2000; number <= 2010; ++number)
    for (unsigned bit = 0; bit < 8; ++bit) {
      const bool standard = number == 2003 && bit < 2;
      EXPECT_EQ(data.bit({number, bit}), standard) << number << '.' << bit;
      EXPECT_TRUE(data.setBit({number, bit}, !standard));
      EXPECT_EQ(data.byte(number),
                standard ? 0x03u & ~(1u << bit) : (number == 2003 ? 3u : 0u) | 1u << bit);
      data.setBit({number, bit}, standard);
    }
  EXPECT_FALSE(data.setBit({2011, 0}, true));
  EXPECT_FALSE(data.setBit({2000, 8}, true));
}

// S5-SYS-01, S5-MD-03: where the bits of MD 2003 stand, in the table and in the text.
TEST(MachineData, TableAndText) {
  MachineData data;
  data.setBit({2003, 0}, false);
  EXPECT_TRUE(data.stops(Reaction::StopIfOb1));
  EXPECT_FALSE(data.stops(Reaction::StopIfOb2));
  data.mapping = BitMapping::Text;
  EXPECT_FALSE(data.stops(Reaction::StopIfOb1));
  EXPECT_TRUE(data.stops(Reaction::StopIfOb2));
  data.setBit({2003, 4}, true);
  EXPECT_FALSE(data.systemCommands());
  data.mapping = BitMapping::Table;
  EXPECT_TRUE(data.systemCommands());
}

// S5-SYS-01: LIR stops the PLC unless MD 2003 enables it.
TEST(MachineData, SystemCommandsAreEnabled) {
  for (const bool enabled : {false, true}) {
    ListingBench b(
        "OB 1\n SPA FB 1\nNAME : LESEN\n BE\nFB 1\nNAME : LESEN\n L KB 5\n T MW 100\n L KB 0\n"
        " T MW 102\n L MD 100\n LIR 0\n T MW 104\n BE\n");
    b.set(2003, 4, enabled);
    b.run(10);
    EXPECT_EQ(b.stopped(Alarm::SystemCommandsLocked), !enabled);
    EXPECT_EQ(b.value("MW 104"), enabled ? 0x7070u : 0u);  // S5-MEM-01: the first header
  }
}

// S5-MD-05: without MD 2002 bit 4 there is no distributed unit and no alarm of it.
TEST(MachineData, DistributedUnit) {
  for (const bool connected : {false, true}) {
    ListingBench b(kOb1);
    b.set(2002, 4, connected);
    b.run(70);
    b.plc().surroundings().unit = {
        .answers = false, .transmission = false, .overTemperature = true, .changed = true};
    b.runTo(130);
    for (const unsigned alarm : {6138u, 6139u, 6147u, 6148u})
      EXPECT_EQ(b.pending(alarm), connected) << alarm;
    EXPECT_EQ(b.value("DB1.DW 8"), connected ? 0x000Fu : 0u);  // S5-ERR-02
  }
}

// S5-MD-07: user words, binary or BCD.
TEST(MachineData, UserWords) {
  MachineData data;
  EXPECT_TRUE(data.setWord(1000, 25));
  EXPECT_EQ(data.userValue(1000), 0x19u);
  data.setBit({2000, 0}, true);
  EXPECT_EQ(data.userValue(1000), 0x25u);
  EXPECT_TRUE(data.setWord(1007, 7));
  EXPECT_FALSE(data.setWord(1008, 1));
}

// S5-MD-08: MD 155 is none of the PLC's words.
TEST(MachineData, SamplingCodeBelongsToTheNc) {
  for (const WordRow& row : wordRows()) EXPECT_NE(row.number, 155u);
  EXPECT_FALSE(MachineData().setWord(155, 2));
  EXPECT_EQ(MachineData().samplingCode, 2);
}

}  // namespace
}  // namespace merker::sinumerik
