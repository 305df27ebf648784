// A PLC that runs a STEP 5 listing.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "softplc/plc.h"
#include "step5/compiler.h"
#include "step5/variable.h"

namespace merker::sinumerik {

inline Instant ms(double milliseconds) {
  return {static_cast<std::int64_t>(milliseconds * 1'000'000)};
}

// Statements that take this long on the ACOP: +G with 193 µs each.
inline std::string burn(double milliseconds) {
  std::string text;
  for (int i = 0; i < milliseconds * 1000 / 193; ++i) text += " +G\n";
  return text;
}

struct ListingBench {
  explicit ListingBench(const std::string& listing) {
    std::vector<source::SourceFile> files;
    files.emplace_back("t.s5", listing);
    auto compiled = step5::compile(files, true);
    for (const Problem& problem : compiled.problems.list())
      if (problem.severity() == Severity::Error)
        ADD_FAILURE() << problem.name() << " in line " << problem.position.line;
    options.program = std::move(compiled.program);
  }
  MachineData& data() {
    if (!options.machineData)
      options.machineData =
          MachineData::standard(options.program.contains({mc5::BlockType::Ob, 2}));
    return *options.machineData;
  }
  void set(unsigned number, unsigned bit, bool on = true) {
    EXPECT_TRUE(data().setBit({number, bit}, on));
  }
  Plc& plc() {
    if (!built) built.emplace(options);
    return *built;
  }
  // Builds, cold-starts and runs so long.
  Plc& run(double milliseconds = 0) {
    plc().coldStart();
    plc().advanceTo(ms(milliseconds));
    return plc();
  }
  void runTo(double milliseconds) { plc().advanceTo(ms(milliseconds)); }
  unsigned value(std::string_view operand) {
    const auto variable = step5::parseVariable(operand);
    EXPECT_TRUE(variable.has_value()) << operand;
    return variable ? plc().read(*variable).value_or(0xDEAD) : 0xDEAD;
  }
  bool write(std::string_view operand, unsigned value) {
    const auto variable = step5::parseVariable(operand);
    return variable && plc().write(*variable, value);
  }
  unsigned address(unsigned pseudoAddress) {
    return plc().programmer().address(static_cast<std::uint16_t>(pseudoAddress)).value_or(0xDEAD);
  }
  bool control(ControlBit bit) { return plc().programmer().controlBits().test(bit); }
  // F001 shows the alarm number in BCD.
  unsigned shownAlarm() {
    const unsigned bcd = address(0xF001);
    return (bcd >> 12) * 1000 + (bcd >> 8 & 15) * 100 + (bcd >> 4 & 15) * 10 + (bcd & 15);
  }
  bool stopped(Alarm alarm) {
    return plc().mode() == Mode::Stop && shownAlarm() == number(alarm) &&
           plc().operatingSystem().record().alarms().pending(number(alarm));
  }
  bool pending(unsigned alarm) { return plc().operatingSystem().record().alarms().pending(alarm); }

  Options options;
  std::optional<Plc> built;
};

}  // namespace merker::sinumerik
