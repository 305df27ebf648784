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
VAR_TEMP
 info : ARRAY [1..20] OF BYTE;
END_VAR
BEGIN
 U E 0.0; L S5T#10S; SE T 1;
END_ORGANIZATION_BLOCK
)";

void fill(Plc& plc) {
  plc.write("E 0.0", 1);
  plc->advanceCycles(2);
  plc.write("MB 15", 0x55);
  plc.write("MB 16", 0x66);
  plc.write("Z 7", 0x077);
  plc.write("Z 8", 0x088);
  plc.write("DB1.DBW 0", 33);
  plc.write("DB2.DBW 0", 44);
}

void expectRetained(Plc& plc) {
  EXPECT_EQ(plc.read("MB 15"), 0x55u);
  EXPECT_EQ(plc.read("MB 16"), 0u);
  EXPECT_EQ(plc.read("Z 7"), 1u);  // its status, as for a bit
  EXPECT_EQ(plc.read("Z 8"), 0u);
  EXPECT_EQ(plc.read("DB1.DBW 0"), 33u);
  EXPECT_EQ(plc.read("DB2.DBW 0"), 4u);
}

// S7-CPU-28, S7-MEM-02, S7-STATE-09, S7-TMR-22
TEST(Retentivity, WarmRestart) {
  Plc plc(kProgram);
  plc.start();
  fill(plc);
  plc->stop();
  plc.write("E 0.0", 0);
  plc.cycles(1);
  expectRetained(plc);
  EXPECT_EQ(plc.read("T 1"), 0u);
  EXPECT_EQ(plc.read("E 0.0"), 0u);
}

TEST(Retentivity, PowerFailure) {
  Plc plc(kProgram);
  plc.start();
  fill(plc);
  plc->powerOff();
  EXPECT_EQ(plc->mode(), Mode::Stop);
  EXPECT_FALSE(plc->warmRestart());
  plc.write("E 0.0", 0);
  plc.run(Duration::seconds(5));
  plc->powerOn();
  plc->advanceCycles(1);
  EXPECT_EQ(plc->mode(), Mode::Run);
  expectRetained(plc);
  EXPECT_TRUE(plc.hasEvent(0x4300));
  EXPECT_TRUE(plc.hasEvent(0x1382));
}

// S7-MEM-04: values of load memory are replaced in STOP only; a memory reset then brings them.
TEST(Retentivity, CopyRamToRom) {
  Plc plc(kProgram);
  plc.start();
  fill(plc);
  EXPECT_NE(plc->copyRamToRom(), "");
  plc->memoryReset();
  plc.write("DB1.DBW 0", 33);
  EXPECT_EQ(plc->copyRamToRom(), "");
  plc.write("DB1.DBW 0", 34);
  plc->memoryReset();
  EXPECT_EQ(plc.read("DB1.DBW 0"), 33u);
}

// S7-STATE-10
TEST(Retentivity, MemoryReset) {
  Plc plc(kProgram);
  plc.start();
  fill(plc);
  plc->memoryReset();
  EXPECT_EQ(plc->mode(), Mode::Stop);
  EXPECT_EQ(plc.read("MB 15"), 0u);
  EXPECT_EQ(plc.read("Z 7"), 0u);
  EXPECT_EQ(plc.read("DB1.DBW 0"), 3u);
  EXPECT_TRUE(plc.hasEvent(0x4301));  // the buffer stays
  EXPECT_TRUE(plc.hasEvent(0x430E));
}

}  // namespace
}  // namespace merker::station::test
