// A power failure that ends the process: another station goes on with what the first one kept.
#include <gtest/gtest.h>

#include "program.h"

namespace merker::station::test {
namespace {

constexpr std::string_view kProgram = R"(
DATA_BLOCK DB 1
STRUCT
 a : INT := 3;
END_STRUCT;
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 2
NON_RETAIN
STRUCT
 a : INT := 4;
END_STRUCT;
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
 U E 0.0; L S5T#10S; SE T 1;
END_ORGANIZATION_BLOCK
ORGANIZATION_BLOCK OB 100
BEGIN
 L LB 1; T MB 100;
END_ORGANIZATION_BLOCK
)";

// Retentive timers, which the 314C has not by default (S7-CPU-28).
CpuModel withRetentiveTimers() {
  CpuModel model = defaultCpuModel();
  model.retentiveTimers = 2;
  return model;
}

block::RetentiveData filled(const CpuModel& model, bool stopped) {
  Plc plc(kProgram, model);
  plc.start();
  plc.write("E 0.0", 1);
  plc->advanceCycles(2);
  plc->advanceTo(plc->now() + Duration::seconds(4));
  plc->settle();
  plc.write("MB 15", 0x55);
  plc.write("MB 16", 0x66);
  plc.write("Z 7", 0x077);
  plc.write("DB1.DBW 0", 33);
  plc.write("DB2.DBW 0", 44);
  if (stopped) plc->stop();
  block::RetentiveData data;
  plc->retentive(data);
  return data;
}

// S7-MEM-02, S7-CPU-28, S7-STATE-09
TEST(PowerFailure, AnotherStationGoesOn) {
  const CpuModel model = withRetentiveTimers();
  const block::RetentiveData data = filled(model, false);
  Plc plc(kProgram, model);
  plc->restore(data);
  EXPECT_EQ(plc->mode(), Mode::Stop);
  plc->powerOn();
  plc.write("E 0.0", 1);
  plc->advanceCycles(1);
  EXPECT_EQ(plc->mode(), Mode::Run);
  EXPECT_EQ(plc.read("MB 15"), 0x55u);
  EXPECT_EQ(plc.read("MB 16"), 0u);
  EXPECT_EQ(plc.read("Z 7"), 1u);
  EXPECT_EQ(plc.read("DB1.DBW 0"), 33u);
  EXPECT_EQ(plc.read("DB2.DBW 0"), 4u);
  EXPECT_EQ(plc.read("MB 100"), 0x82u);  // automatic warm restart
  EXPECT_TRUE(plc.hasEvent(0x4300));
  EXPECT_TRUE(plc.hasEvent(0x1382));
}

// The time that was left runs on, whatever the clock of the first station showed.
TEST(PowerFailure, TimersGoOnWhereTheyWere) {
  const CpuModel model = withRetentiveTimers();
  Plc plc(kProgram, model);
  plc->restore(filled(model, false));
  plc->powerOn();
  plc.write("E 0.0", 1);
  plc->advanceTo(Instant{} + Duration::milliseconds(5900));
  plc->settle();
  EXPECT_EQ(plc.read("T 1"), 0u);
  plc->advanceTo(Instant{} + Duration::milliseconds(6100));
  plc->settle();
  EXPECT_EQ(plc.read("T 1"), 1u);
}

TEST(PowerFailure, WhoWasStoppedStaysStopped) {
  const CpuModel model = withRetentiveTimers();
  const block::RetentiveData data = filled(model, true);
  EXPECT_FALSE(data.running);
  Plc plc(kProgram, model);
  plc->restore(data);
  plc->powerOn();
  EXPECT_EQ(plc->mode(), Mode::Stop);
  EXPECT_EQ(plc.lastEvent(), 0x4300u);
  EXPECT_EQ(plc.read("MB 15"), 0x55u);
}

// S7-DIAG-01, S7-CPU-32: buffer and clock go on.
TEST(PowerFailure, DiagnosticBufferAndClock) {
  const CpuModel model = withRetentiveTimers();
  const block::RetentiveData data = filled(model, true);
  Plc plc(kProgram, model);
  plc->restore(data);
  block::RetentiveData again;
  plc->retentive(again);
  EXPECT_EQ(again.clock, data.clock);
  ASSERT_EQ(again.events.size(), data.events.size());
  for (std::size_t i = 0; i < data.events.size(); ++i) {
    EXPECT_EQ(again.events[i].event, data.events[i].event);
    EXPECT_EQ(again.events[i].time - again.now, data.events[i].time - data.now);
    EXPECT_EQ(again.events[i].stamp, data.events[i].stamp);
    EXPECT_EQ(again.events[i].info, data.events[i].info);
  }
}

// S7-SFC-03: what it counted stays, and it stands still until SFC 3.
TEST(PowerFailure, RunTimeMeter) {
  const CpuModel model = withRetentiveTimers();
  block::RetentiveData data = filled(model, false);
  ASSERT_FALSE(data.meters.empty());
  data.meters[0] = {.counted = 50, .since = data.now - 7, .running = true};
  Plc plc(kProgram, model);
  plc->restore(data);
  block::RetentiveData again;
  plc->retentive(again);
  EXPECT_EQ(again.meters[0].counted, 57);
  EXPECT_FALSE(again.meters[0].running);
}

// What was never written stays: data of another length belongs to another block.
TEST(PowerFailure, DataOfAnotherLengthIsLeftOut) {
  const CpuModel model = withRetentiveTimers();
  block::RetentiveData data = filled(model, true);
  data.dataBlocks[0].bytes.resize(20, 0xFF);
  data.flags.resize(1000, 0xFF);
  data.timers.resize(1000);
  data.counters.resize(1000);
  Plc plc(kProgram, model);
  plc->restore(data);
  EXPECT_EQ(plc.read("DB1.DBW 0"), 3u);
}

}  // namespace
}  // namespace merker::station::test
