// Every figure of the catalogue (S7-CPU-02 to -18, S7-HW-05 to -10, CNT-PIN-01 to -09): the sources
// stand beside the rows in src/ground/catalogue.
#include "../rows.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "catalogue/counting.h"
#include "catalogue/cpu_model.h"
#include "catalogue/measuring_range.h"
#include "catalogue/module_type.h"

namespace merker {
namespace {

std::string limits(const CpuModel& m) {
  return fmt::format(
      "  firmware {} cycle {} ns work {} block {} db {} load {}\n"
      "  flags {} image {} periphery {} local {} timers {} counters {} meters {}\n"
      "  DB {} FB {} FC {} nesting {}+{} brackets {} MCR {} accumulators {} monitoring {} ms\n"
      "  retentive {} {} {} hot {} cold {} all periphery {}\n",
      fmt::join(m.firmware, "."), m.cycleTime, m.workMemory, m.blockSize, m.dataBlockSize,
      m.loadMemory, m.flagBytes, m.imageBytes, m.peripheralBytes, m.localBytes, m.timers,
      m.counters, m.runtimeMeters, m.highestDb, m.highestFb, m.highestFc, m.nesting, m.errorNesting,
      m.bracketDepth, m.mcrDepth, m.accumulators, m.cycleMonitoring, m.retentiveFlags,
      m.retentiveTimers, m.retentiveCounters, m.hotRestart, m.coldRestart, m.allPeripheral);
}

std::string hardware(const CpuModel& m) {
  const OnBoard& b = m.onBoard;
  return fmt::format(
      "  racks {} DI/DO {} AI/AO {} bus {} mA\n"
      "  on board DI {} DO {} AI {} AO {} counters {} positioning {} at {} {} {} {}\n"
      "  OB {}\n  without SFC {} SFB {}\n",
      m.racks, m.digitalChannels, m.analogChannels, m.busCurrent, b.digitalInputs, b.digitalOutputs,
      b.analogInputs, b.analogOutputs, b.counters, b.positioning, b.digital, b.analog, b.counting,
      b.positions, fmt::join(m.organizationBlocks, " "), fmt::join(m.lacksSfcs, " "),
      fmt::join(m.lacksSfbs, " "));
}

std::string counting(const CpuModel& m) {
  const CountingType* type = countingType(m);
  if (type == nullptr) return "";
  std::string text =
      fmt::format("  counting {} kHz at {}:", fmt::join(type->frequencies, " "), type->connector);
  for (const CountingPins& c : type->channels)
    for (const CountingPin pin : {c.a, c.b, c.gate, c.latch, c.output})
      text += fmt::format(" {}={}", pin.channel, pin.pin);
  return text + '\n';
}

TEST(Rows, CpuModels) {
  std::string rows;
  for (const CpuModel& m : cpuModels()) {
    rows += fmt::format("{} ({}) {} times {} {} {} {} ns\n", m.name, m.keyword, m.orderNumber,
                        m.time(TimeClass::Bit), m.time(TimeClass::Word), m.time(TimeClass::Fixed),
                        m.time(TimeClass::Real));
    rows += limits(m) + hardware(m) + counting(m);
  }
  test::expectRows("catalogue/cpus.txt", rows);
}

std::string row(const ModuleType& m) {
  return fmt::format(
      "{} {} {} kind {} DI {} DO {} AI {} AO {} bytes {}/{} {} mA {}\n"
      "  interrupts {:X} by {} diagnosis {} substitutes {} delay {} of {}\n"
      "  bits {} sign {} ranges {}/{} last {} by {} conversion {} us wire break {}\n",
      m.orderNumber, m.name, m.text, static_cast<int>(m.kind), m.digitalInputs, m.digitalOutputs,
      m.analogInputs, m.analogOutputs, m.inputBytes, m.outputBytes, m.busCurrent, m.signal,
      m.interruptChannels, m.interruptGroup, m.diagnosticInterrupt, m.substituteValues,
      m.inputDelay, fmt::join(m.inputDelays, " "), m.resolution, m.signInResolution, m.inputRanges,
      m.outputRanges, m.lastInputRanges, m.rangeGroup, m.conversionTime, m.wireBreakCheck);
}

TEST(Rows, Modules) {
  std::string rows;
  for (const ModuleType& m : moduleTypes()) rows += row(m);
  for (const ModuleType& m : onBoardTypes()) rows += row(m);
  test::expectRows("catalogue/modules.txt", rows);
}

TEST(Rows, MeasuringRanges) {
  std::string rows;
  for (const MeasuringRange& r : measuringRanges())
    rows += fmt::format("{} {} sets {} {}..{} shown {}..{} limits {}..{} wire break {}\n", r.name,
                        unitOf(r.quantity), r.sets, r.low, r.high, r.shownLow, r.shownHigh,
                        r.lowest, r.highest, r.wireBreak);
  test::expectRows("catalogue/ranges.txt", rows);
}

}  // namespace
}  // namespace merker
