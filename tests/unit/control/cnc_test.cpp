// A control put together: what PLC, NC and project have in common.
#include "control/cnc.h"

#include <gtest/gtest.h>

#include <ctime>

#include "control/memory.h"
#include "control/reference.h"
#include "softplc/sinumerik_model.h"
#include "step5/compiler.h"

namespace merker::cnc {
namespace {

mc5::Block block(mc5::BlockType type, std::uint16_t number, std::size_t words) {
  mc5::Block result;
  result.id = {type, number};
  result.words.assign(words, 0);
  if (type != mc5::BlockType::Db) result.words.back() = 0x6500;  // BE
  return result;
}

// S5-FM-42 (MDN), S5-MD-08: datum 155 of the NC is the one that the PLC reads.
TEST(Cnc, SamplingTimeIsOneDatum) {
  Options options;
  options.machineData = {{kSamplingDatum, 3}};
  Cnc control(std::move(options));
  EXPECT_EQ(control.control().machineData[kSamplingDatum], 3);
  EXPECT_EQ(Cnc(Options{}).control().machineData[kSamplingDatum], 2);
  control.control().machineData[kSamplingDatum] = 0;  // as FB 62 writes it
  EXPECT_EQ(control.plc().machineData().samplingCode, 3);
  control.start();
  EXPECT_EQ(control.plc().machineData().samplingCode, 0);
}

// S5-SCHED-13, S5-DB-16, S5-MEM-08: 16 kB of program, 12 with COP, 6 kB of data.
TEST(Cnc, RoomForBlocks) {
  Options options;
  const auto load = [&](const mc5::Block& b) { options.plc.program[b.id] = b; };
  load(block(mc5::BlockType::Pb, 1, 8192 - 2 * 5 - 3));
  load(block(mc5::BlockType::Pb, 2, 3));
  load(block(mc5::BlockType::Db, 10, 1024));
  load(block(mc5::BlockType::Db, 11, 2048 - 2 * 5));
  EXPECT_TRUE(memoryUse(options).missing.empty());
  EXPECT_EQ(memoryUse(options).program.used, 8192u);
  EXPECT_EQ(memoryUse(options).data.used, 3072u);
  load(block(mc5::BlockType::Db, 12, 1));
  const MemoryUse use = memoryUse(options);
  ASSERT_EQ(use.missing.size(), 1u);
  EXPECT_EQ(use.missing[0].block, (mc5::BlockId{mc5::BlockType::Db, 12}));
  EXPECT_EQ(use.missing[0].words, 6u);
  Cnc control(options);
  EXPECT_EQ(control.plc().refused().size(), 1u);  // what the PLC really does
  options.model = findSinumerikModel("SINUMERIK 810 GA3 COP");
  EXPECT_EQ(memoryUse(options).program.size, 6144u);
  EXPECT_EQ(memoryUse(options).missing.size(), 2u);
}

// Numbers of 32 bits need no type: data double words have none.
TEST(Cnc, LongIntegers) {
  EXPECT_EQ(parseConstant("123450")->bits, 123450u);
  EXPECT_EQ(parseConstant("-123450")->bits, static_cast<std::uint32_t>(-123450));
  EXPECT_FALSE(parseConstant("12").has_value());  // of 16 bits, as everywhere
  EXPECT_FALSE(parseConstant("4294967296").has_value());
  EXPECT_EQ(parseConstant("KF -5")->bits, 0xFFFBu);
}

// docs/safety.md: each call of a function block may have code of its own, but not all of them.
double translation(int calls) {
  std::string text = "FB 200\nNAME : LONG\nBEZ  : EIN  E BI\n";
  for (int i = 0; i < 2000; ++i) text += "      U     =EIN\n      =     A 0.0\n";
  text += "      BE\nOB 1\n";
  for (int i = 0; i < calls; ++i) text += "      SPB   FB 200\nNAME : LONG\nEIN  : E 1.0\n";
  text += "      BE\n";
  Options options;
  options.compiled = true;
  options.plc.program = step5::compile({source::SourceFile("a.s5", text)}, false, {}).program;
  EXPECT_EQ(options.plc.program.size(), 2u);
  Cnc control(std::move(options));
  const std::clock_t before = std::clock();
  control.plc().translate();
  return static_cast<double>(std::clock() - before);
}

TEST(Cnc, TranslationTakesNoLongerForEachCall) {
  if (!Cnc::canCompile()) GTEST_SKIP() << "no compiler for this processor";
  EXPECT_LT(translation(500), 10 * translation(1));
}

}  // namespace
}  // namespace merker::cnc
