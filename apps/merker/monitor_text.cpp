#include "monitor_text.h"

#include <fmt/format.h>

#include "scenario/duration.h"

namespace merker::app {
namespace {

std::string blockNumber(std::uint16_t number) { return number == 0 ? "-" : std::to_string(number); }

// Sixteen bytes a line, behind their address.
std::string dump(const std::vector<std::uint8_t>& bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (i % 16 == 0) text += fmt::format("{}    LB {:<5}", i == 0 ? "" : "\n", i);
    text += fmt::format(" {:02X}", bytes[i]);
  }
  return text.empty() ? "    none\n" : text + "\n";
}

// STEP 5 has no binary result, no address registers and no DI.
bool hasStep5Registers(const monitor::Registers& r) { return !r.br; }

// As the screen of an interrupt stack names them (S5-ERR-08).
std::string step5Registers(const monitor::Registers& r) {
  std::string text;
  for (unsigned i = 0; i < r.accumulators; ++i)
    text += fmt::format("{}AKKU{} {:04X} {:04X} (KF {:+})", i == 0 ? "" : "  ", i + 1,
                        r.accu[i] >> 16, r.accu[i] & 0xFFFF, static_cast<std::int16_t>(r.accu[i]));
  return text + fmt::format(
                    "\nANZ1 {:d}  ANZ0 {:d}  OVFL {:d}  OVFLS {:d}  ODER {:d}  STATUS {:d}  VKE "
                    "{:d}  ERAB {:d}\nDB {}\n",
                    r.cc1, r.cc0, r.ov, r.os, r.orBit, r.sta, r.rlo, r.er, blockNumber(r.db));
}

std::string step7Registers(const monitor::Registers& r) {
  std::string text;
  for (unsigned i = 0; i < r.accumulators; ++i)
    text += fmt::format("{}AKKU{} DW#16#{:08X} ({})", i == 0 ? "" : "  ", i + 1, r.accu[i],
                        static_cast<std::int32_t>(r.accu[i]));
  text += '\n';
  text +=
      fmt::format("AR1 {}  AR2 {}\n", formatConstant({ConstantFormat::Pointer, r.ar1.value_or(0)}),
                  formatConstant({ConstantFormat::Pointer, r.ar2.value_or(0)}));
  text += fmt::format(
      "BIE {:d}  A1 {:d}  A0 {:d}  OV {:d}  OS {:d}  OR {:d}  STA {:d}  VKE {:d}  /ER {:d}   STW "
      "W#16#{:04X}\n",
      r.br.value_or(false), r.cc1, r.cc0, r.ov, r.os, r.orBit, r.sta, r.rlo, r.er, r.word);
  return text + fmt::format("DB {}  DI {}\n", blockNumber(r.db), blockNumber(r.di.value_or(0)));
}

std::string cycleTimesText(const monitor::ModuleInformation& info) {
  std::string text;
  if (info.raster && info.raster->length.ns != 0)
    text = fmt::format("  every {}  program {} in the last one ({}.{} %)",
                       simulator::formatTime(Instant{} + info.raster->length),
                       simulator::formatTime(Instant{} + info.raster->runTime),
                       info.raster->loadPerMille / 10, info.raster->loadPerMille % 10);
  else if (!info.raster)
    text = fmt::format("  cycle time last {} ms, shortest {} ms, longest {} ms", info.lastCycle,
                       info.shortestCycle, info.longestCycle);
  if (info.raster && info.cycleMonitoring != 0)
    text += fmt::format("  cycle monitoring {} ms", info.cycleMonitoring);
  return text;
}

}  // namespace

std::string registersText(const monitor::Registers& r) {
  return hasStep5Registers(r) ? step5Registers(r) : step7Registers(r);
}

std::string blockStackText(const monitor::Stacks& stacks) {
  std::string text;
  for (std::size_t i = 0; i < stacks.blocks.size(); ++i) {
    const monitor::BlockStackEntry& entry = stacks.blocks[i];
    const std::string db = blockNumber(entry.db);
    text += fmt::format(
        "{:>3}  {:<40} DB {}\n", i, monitor::toString(entry.place),
        stacks.withoutDi() ? db : fmt::format("{:<8} DI {}", db, blockNumber(entry.di)));
  }
  return text.empty() ? "no block runs\n" : text;
}

std::string interruptStackText(const monitor::Stacks& stacks) {
  std::string text;
  for (const monitor::InterruptStackEntry& entry : stacks.interrupts) {
    const bool step5 = hasStep5Registers(entry.registers);  // neither priorities nor MCR
    text += fmt::format("OB {}{}, at {}\n", entry.ob,
                        step5 ? "" : fmt::format(", priority {}", entry.priority),
                        monitor::toString(entry.place));
    text += registersText(entry.registers);
    text += fmt::format("brackets {}{}\n", entry.brackets.size(),
                        step5 ? "" : fmt::format("  MCR levels {}", entry.mcr.size()));
  }
  return text.empty() ? "nothing was interrupted\n" : text;
}

std::string localStackText(const monitor::Stacks& stacks) {
  std::string text;
  for (const monitor::LocalStackEntry& entry : stacks.locals)
    text += fmt::format("  {}, {} bytes\n{}", toString(entry.block), entry.bytes.size(),
                        dump(entry.bytes));
  return text.empty() ? "  none\n" : text;
}

std::string diagnosticsText(const std::vector<monitor::DiagnosticLine>& lines, std::size_t count) {
  std::string text;
  for (const monitor::DiagnosticLine& line : lines) {
    if (line.number > count) break;
    const std::string clock =
        line.clock ? monitor::clockText(*line.clock) : simulator::formatTime(line.time);
    const bool named =
        line.text.find(line.eventText) != std::string::npos;  // an alarm names itself
    text += fmt::format("{:>3}  {}  {}{}{}\n", line.number, clock, named ? "" : line.eventText,
                        named ? "" : "  ", line.text);
    if (line.place) text += fmt::format("       at {}\n", monitor::toString(*line.place));
    if (!line.help.empty()) text += fmt::format("       {}\n", line.help);
  }
  return text.empty() ? "the diagnostic buffer is empty\n" : text;
}

std::string informationText(const monitor::ModuleInformation& info) {
  std::string text = fmt::format("{}  {}", info.model, monitor::name(info.mode));
  if (!info.stopReason.empty()) text += ": " + info.stopReason;
  text += fmt::format("\ntime {}{}{}\n", simulator::formatTime(info.time),
                      info.clock.empty() ? "" : "  clock ", info.clock);
  text += fmt::format("cycles {}  instructions {}{}\n", info.cycles, info.instructions,
                      cycleTimesText(info));
  text += fmt::format("blocks {}", info.blocks);
  if (info.loadMemory != 0) text += fmt::format("  load memory {} bytes", info.loadMemory);
  text += fmt::format("  work memory {} of {} bytes", info.workMemoryUsed, info.workMemory);
  if (info.localData != 0) text += fmt::format("  local data {} bytes", info.localData);
  return text + "\n";
}

}  // namespace merker::app
