// Start-up, call raster, process images (chapters 1.3.3, 5).
#include "plc_bench.h"

namespace merker::sinumerik {
namespace {

using mc5::Area;
using mc5::BlockType;
using mc5::Width;

// S5-OB-01, S5-OB-05, S5-OB-19: OB 20 once, OB 1 every 60 ms.
TEST(Cycle, StartUpOnceThenTheRaster) {
  PlcBench b;
  b.ob(20, countUp(120)).ob(1, countUp(122));
  Plc& plc = b.run();
  plc.advanceTo(at(1'000'000));
  EXPECT_EQ(plc.mode(), Mode::Run);
  EXPECT_EQ(b.value(flagWord(120)), 1u);
  EXPECT_EQ(b.value(flagWord(122)), 17u);  // at 0, 60, … 960 ms
  EXPECT_EQ(plc.cycles(), 17u);
}

// S5-SCHED-01, S5-SCHED-02: the table of the call raster.
TEST(Cycle, CallRasterOfEachMachineDatum) {
  for (unsigned code = 0; code <= 5; ++code)
    for (unsigned factor = 1; factor <= 3; ++factor) {
      PlcBench b;
      b.ob(1, countUp(122));
      b.data().samplingCode = static_cast<std::uint8_t>(code);
      b.data().setWord(2, static_cast<std::uint16_t>(factor));
      b.data().setWord(5, 100);
      Plc& plc = b.run();
      std::vector<std::int64_t> starts;
      plc.advanceTo(at(1'000));
      for (int i = 0; i < 3; ++i) {
        plc.advanceToCheckpoint(at(1'000'000));
        starts.push_back(plc.now().ns / 1'000'000);
      }
      EXPECT_EQ(starts[1] - starts[0], (16 + 2 * code) * factor);
      EXPECT_EQ(starts[2] - starts[1], (16 + 2 * code) * factor);
    }
}

// S5-SCHED-02, S5-OPC-07: COP does not look at PLC-MD 2; 0 and 3 mean the same.
TEST(Cycle, CopHasAFixedRaster) {
  EXPECT_EQ(makeRaster(2, 1, mc5::Variant::Cop, Software::Sw1).call, Duration::milliseconds(60));
  EXPECT_EQ(makeRaster(2, 0, mc5::Variant::Acop, Software::Sw2).call, Duration::milliseconds(60));
  EXPECT_EQ(makeRaster(0, 3, mc5::Variant::Acop, Software::Sw2).ipo, Duration::milliseconds(16));
}

// S5-OB-02, S5-FLAG-05: M 3.0 tells OB 20 which start it is.
TEST(Cycle, ColdStartAndWarmRestart) {
  PlcBench b;
  b.ob(20, {0x0A03, 0x0B64}).ob(1, countUp(122));  // L MB 3, T MB 100
  Plc& plc = b.run();
  plc.advanceTo(at(100'000));
  EXPECT_EQ(b.value(flagByte(100)) & 1, 1u);
  plc.stop();
  EXPECT_TRUE(plc.warmStart());
  EXPECT_EQ(b.value(flagWord(122)), 2u);  // flags stay
  plc.settle();
  EXPECT_EQ(b.value(flagByte(100)) & 1, 0u);
  EXPECT_TRUE(plc.programmer().controlBits().test(ControlBit::WIEDAN));
  plc.coldStart();
  EXPECT_EQ(b.value(flagWord(122)), 0u);
  EXPECT_TRUE(plc.programmer().controlBits().test(ControlBit::NEUSTA));
}

// S5-OB-03: power fails in OB 20 of a warm restart; then it is a cold start.
TEST(Cycle, AnInterruptedWarmRestartBecomesAColdStart) {
  PlcBench b;
  std::vector<unsigned> long20 = {0x0A03, 0x0B64};
  const auto wait = burn(10'000);
  long20.insert(long20.end(), wait.begin(), wait.end());
  b.ob(20, long20).ob(1, {});
  b.data().setBit(data_bit::kWarmRestart, true);
  Plc& plc = b.run();
  plc.advanceTo(at(100'000));
  plc.powerOff();
  plc.powerOn();
  plc.advanceTo(at(105'000));
  EXPECT_EQ(plc.mode(), Mode::Startup);
  EXPECT_EQ(b.value(flagByte(100)) & 1, 0u);
  plc.powerOff();
  plc.powerOn();
  plc.advanceTo(at(106'000));
  EXPECT_EQ(b.value(flagByte(100)) & 1, 1u);
}

// S5-OB-04: MD 2003 bit 3 decides what the return of power is.
TEST(Cycle, ReturnOfPower) {
  for (const bool warm : {false, true}) {
    PlcBench b;
    b.ob(1, {});
    b.data().setBit(data_bit::kWarmRestart, warm);
    Plc& plc = b.run();
    plc.advanceTo(at(100'000));
    plc.powerOff();
    EXPECT_EQ(plc.mode(), Mode::Off);
    plc.powerOn();
    EXPECT_EQ(plc.programmer().controlBits().test(ControlBit::WIEDAN), warm);
  }
}

// S5-MEM-09: program and data survive, images and flags do not.
TEST(Cycle, PowerOffKeepsTheBufferedMemory) {
  PlcBench b;
  b.ob(1, {0x200A, 0x3040, 0x1234, 0x3300, 0x0B64}).block(BlockType::Db, 10, {0, 0});
  Plc& plc = b.run();
  plc.advanceTo(at(100'000));
  EXPECT_EQ(b.value(flagByte(100)), 0x34u);
  plc.powerOff();
  EXPECT_EQ(b.value(flagByte(100)), 0u);
  EXPECT_EQ(b.value(dataWord(10, 0)), 0x1234u);
  plc.powerOn(false);
  EXPECT_EQ(plc.mode(), Mode::Stop);
  const ControlBits bits = plc.programmer().controlBits();
  EXPECT_TRUE(bits.test(ControlBit::URLAD) && bits.test(ControlBit::NINEU));
  EXPECT_FALSE(bits.test(ControlBit::BATPUF));
  EXPECT_FALSE(plc.read(dataWord(10, 0)).has_value());
}

// The buffered memory goes to another PLC with the same contents (S5-MEM-09).
TEST(Cycle, RetainedMemoryMoves) {
  PlcBench b;
  b.ob(1, {0x200A, 0x3040, 0x1234, 0x3300}).block(BlockType::Db, 10, {0, 0});
  b.run().advanceTo(at(10'000));
  const PlcBench empty;
  Plc other(empty.options);
  other.restore(b.plc().retained());
  EXPECT_EQ(other.mode(), Mode::Off);
  other.powerOn();
  EXPECT_EQ(other.mode(), Mode::Run);
  EXPECT_EQ(other.read(dataWord(10, 0)), 0x1234u);
}

// S5-OB-16, S5-LOAD-13: inputs are read before OB 1, outputs written behind it.
TEST(Cycle, ImagesAreUpdatedAroundOb1) {
  PlcBench b;
  std::vector<unsigned> ob1 = {0x4A00, 0x4B84};  // L EB 0, T AB 4
  const auto wait = burn(4'000);
  ob1.insert(ob1.end(), wait.begin(), wait.end());
  ob1.insert(ob1.end(), {0x4A00, 0x0B64});  // L EB 0, T MB 100
  b.ob(1, ob1);
  Plc& plc = b.run();
  plc.advanceTo(at(30'000));
  const Reference output = memory(Area::Peripheral, Width::Byte, 4);
  plc.write(memory(Area::Input, Width::Byte, 0), 0x55);
  plc.advanceTo(at(62'000));  // in OB 1
  plc.write(memory(Area::Input, Width::Byte, 0), 0x66);
  EXPECT_EQ(b.value(memory(Area::Output, Width::Byte, 4)), 0x55u);
  EXPECT_EQ(b.value(output), 0u);
  plc.settle();
  EXPECT_EQ(b.value(output), 0x55u);
  EXPECT_EQ(b.value(flagByte(100)), 0x55u);
}

// S5-OB-09: OB 1 and OB 20 may be missing, OB 2 not while it could be called (OP-08).
TEST(Cycle, MissingOrganizationBlocks) {
  PlcBench empty;
  empty.run().advanceTo(at(200'000));
  EXPECT_EQ(empty.plc().mode(), Mode::Run);
  EXPECT_EQ(empty.plc().cycles(), 4u);
  PlcBench alarm;
  alarm.ob(1, {});
  alarm.data().setBit(data_bit::kNoAlarmLevel, false);
  EXPECT_TRUE(alarm.refuses(Alarm::MissingBlock));
  EXPECT_EQ(alarm.plc().programmer().address(0xF004), 2u);
}

// S5-BLK-04: only OB 1, OB 2 and OB 20 are served.
TEST(Cycle, OtherOrganizationBlocksNeverRun) {
  PlcBench b;
  b.ob(1, {}).ob(30, countUp(122)).ob(64, {});
  b.run().advanceTo(at(500'000));
  EXPECT_EQ(b.value(flagWord(122)), 0u);
  ASSERT_EQ(b.plc().refused().size(), 1u);
  EXPECT_EQ(b.plc().refused()[0], "OB 64: OB 64 cannot be created");
}

// S5-OB-21: each pass begins with empty registers; S5-DB-17: and with no open DB.
TEST(Cycle, EachPassBeginsAnew) {
  PlcBench b;
  b.ob(1, {0x1364, 0x3040, 0x1234});  // T MW 100, L KH 1234
  b.run().advanceTo(at(130'000));
  EXPECT_EQ(b.value(flagWord(100)), 0u);
  PlcBench data;  // the second pass transfers without A DB
  data.ob(1, {0x1264, 0x2801, 0x2180, 0xFA03, 0x200A, 0x2D02, 0x3300, 0x2801, 0x1364})
      .block(BlockType::Db, 10, {0, 0});
  data.run().advanceTo(at(20'000));
  EXPECT_EQ(data.plc().mode(), Mode::Run) << data.plc().stopReason();
  data.plc().advanceTo(at(130'000));
  EXPECT_TRUE(data.stopped(Alarm::TransferToMissingDb));
}

// S5-BLK-19, S5-BLK-20: blocks in any order; a block that is called n times counts n times.
TEST(Cycle, RunTimeIsTheSumOfAllBlocks) {
  const auto cyclicTime = [](unsigned calls) {
    PlcBench b;
    std::vector<unsigned> ob1(calls, 0x7501);
    b.block(BlockType::Pb, 2, {}).ob(1, ob1).block(BlockType::Pb, 1, {0x2801, 0x2801});
    b.run().advanceTo(at(30'000));
    return b.plc().operatingSystem().runTimes().cycle.cyclic.ns;
  };
  const auto none = cyclicTime(0), one = cyclicTime(1);
  EXPECT_EQ(cyclicTime(3) - none, 3 * (one - none));
}

// S5-MD-06: the machine control panel, if MD 2002 bit 3 wants it.
TEST(Cycle, ControlPanelGoesToTheOutputs) {
  for (const bool on : {false, true}) {
    PlcBench b;
    b.ob(1, {});
    b.data().setBit(data_bit::kControlPanelToOutputs, on);
    Plc& plc = b.run();
    plc.write(memory(Area::Input, Width::Byte, 115), 0xA5);
    plc.advanceTo(at(70'000));
    EXPECT_EQ(b.value(memory(Area::Output, Width::Byte, 115)), on ? 0xA5u : 0u);
  }
}

// Values from outside: areas, cells, forces.
TEST(Cycle, ValuesFromOutside) {
  PlcBench b;
  b.ob(1, {}).block(BlockType::Db, 10, {0, 0});
  Plc& plc = b.run();
  EXPECT_TRUE(plc.write(memory(Area::Flag, Width::Double, 200), 0x12345678));
  EXPECT_EQ(b.value(flagByte(200)), 0x12u);
  EXPECT_FALSE(plc.write(memory(Area::Flag, Width::Word, 255), 1));
  EXPECT_TRUE(plc.write(dataWord(10, 1), 0xABCD));
  EXPECT_FALSE(plc.write(dataWord(10, 2), 1));
  EXPECT_FALSE(plc.read(dataWord(11, 0)).has_value());
  const Reference counter = cell(address::OperandKind::Counter, 3);
  EXPECT_TRUE(plc.write(counter, 0x0123));
  EXPECT_EQ(b.value(counter), 0x0123u);
  const Reference timer = cell(address::OperandKind::Timer, 3);
  EXPECT_TRUE(plc.write(timer, 0x1020));  // 20.1 = 2 s
  plc.advanceTo(at(1'001'000));
  EXPECT_EQ(b.value(timer), 0x1010u);
  EXPECT_TRUE(plc.force(inputBit(5, 1), 1));
  plc.advanceTo(at(1'100'000));
  EXPECT_EQ(b.value(inputBit(5, 1)), 1u);
  plc.unforce();
  plc.advanceTo(at(1'200'000));
  EXPECT_EQ(b.value(inputBit(5, 1)), 0u);
}

}  // namespace
}  // namespace merker::sinumerik
