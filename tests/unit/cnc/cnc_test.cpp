// PLC and NC in one control.
#include "cnc/cnc.h"

#include <gtest/gtest.h>

#include "cnc/reference.h"
#include "step5/compiler.h"
#include "step5/variable.h"

namespace merker::cnc {
namespace {

Options program(const std::string& listing) {
  std::vector<source::SourceFile> files;
  files.emplace_back("t.s5", listing);
  auto compiled = step5::compile(files, false);
  EXPECT_TRUE(compiled.ok());
  Options options;
  options.plc.program = std::move(compiled.program);
  return options;
}

std::uint32_t value(const Cnc& control, std::string_view operand) {
  return control.read(toReference(operand, *step5::parseVariable(operand))).value_or(0xDEAD);
}

// S5-FLAG-11
TEST(Cnc, AlarmsOfTheNcReachMb24) {
  Cnc control(program("OB 1\n BE\n"));
  control.start();
  control.advanceCycles(2);
  EXPECT_EQ(value(control, "MB 24"), 0x04u);
  control.control().raise(2041);
  control.advanceCycles(2);
  EXPECT_EQ(value(control, "MB 24"), 0x05u);
  control.control().machiningStop = true;
  control.advanceCycles(2);
  EXPECT_EQ(value(control, "MB 24"), 0x0Du);
  control.control().alarms.clear();
  control.advanceCycles(2);
  EXPECT_EQ(value(control, "MB 24"), 0x04u);
}

// S5-FM-35: a value that the NC refuses is NC alarm 3016, which the program sees.
TEST(Cnc, AWrongValueIsAnAlarmOfTheNc) {
  Cnc control(
      program("OB 1\n SPA FB 62\nNAME : NCD-SCHR\nSCHR : M 100.0\nNSBY : DL 0\nANZ : KF +1\n"
              "DTY1 : KC RP\nDTY2 : KC NC\nDTY3 : KC\nWER1 : KF +1\nWER2 : KF +600\nWER3 : KF +0\n"
              "ZFPN : KC F0\nQUEL : KY 0,160\n U M 24.0\n = M 101.0\n BE\n"));
  control.start();
  control.advanceCycles(2);
  EXPECT_EQ(value(control, "M 101.0"), 0u);
  control.write(toReference("M 100.0", *step5::parseVariable("M 100.0")), 1);
  control.advanceCycles(4);
  EXPECT_EQ(control.control().alarms, (std::vector<std::uint16_t>{3016}));
  EXPECT_EQ(value(control, "M 101.0"), 1u);
  EXPECT_EQ(control.mode(), controller::Mode::Run);
  control.memoryReset();  // everything as it was built
  control.start();
  control.advanceCycles(3);
  EXPECT_EQ(value(control, "M 24.0"), 0u);
}

// The observer outlives a memory reset.
TEST(Cnc, ObserverSeesEachCycle) {
  Cnc control(program("OB 1\n BE\n"));
  int seen = 0;
  control.onCycle([&](controller::Controller&) { ++seen; });
  control.start();
  control.advanceCycles(3);
  const int before = seen;
  EXPECT_GE(before, 3);
  control.memoryReset();
  control.start();
  control.advanceCycles(3);
  EXPECT_GE(seen, before + 3);
}

}  // namespace
}  // namespace merker::cnc
