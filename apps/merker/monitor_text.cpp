#include "monitor_text.h"

#include <fmt/format.h>

#include "scenario/duration.h"

namespace merker::app {
namespace {

std::string blockNumber(std::uint16_t number) {
  return number == 0 ? "-" : fmt::format("DB {}", number);
}

// Sixteen bytes a line, behind their address.
std::string dump(const std::vector<std::uint8_t>& bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (i % 16 == 0) text += fmt::format("{}    LB {:<5}", i == 0 ? "" : "\n", i);
    text += fmt::format(" {:02X}", bytes[i]);
  }
  return text.empty() ? "    none\n" : text + "\n";
}

}  // namespace

// What the machine does not have is not shown.
std::string registersText(const monitor::Registers& r) {
  std::string text;
  for (unsigned i = 0; i < r.accumulators; ++i)
    text += fmt::format("{}AKKU{} DW#16#{:08X} ({})", i == 0 ? "" : "  ", i + 1, r.accu[i],
                        static_cast<std::int32_t>(r.accu[i]));
  text += '\n';
  if (r.ar1 && r.ar2)
    text += fmt::format("AR1 {}  AR2 {}\n", formatConstant({ConstantFormat::Pointer, *r.ar1}),
                        formatConstant({ConstantFormat::Pointer, *r.ar2}));
  if (r.br) text += fmt::format("BIE {:d}  ", *r.br);
  text += fmt::format(
      "A1 {:d}  A0 {:d}  OV {:d}  OS {:d}  OR {:d}  STA {:d}  VKE {:d}  /ER {:d}   STW "
      "W#16#{:04X}\n",
      r.cc1, r.cc0, r.ov, r.os, r.orBit, r.sta, r.rlo, r.er, r.word);
  text += "DB " + blockNumber(r.db);
  return text + (r.di ? "  DI " + blockNumber(*r.di) : "") + "\n";
}

std::string blockStackText(const monitor::Stacks& stacks) {
  std::string text;
  for (std::size_t i = 0; i < stacks.blocks.size(); ++i) {
    const monitor::BlockStackEntry& entry = stacks.blocks[i];
    text += fmt::format("{:>3}  {:<40} DB {:<8} DI {}\n", i, monitor::toString(entry.place),
                        blockNumber(entry.db), blockNumber(entry.di));
  }
  return text.empty() ? "no block runs\n" : text;
}

std::string interruptStackText(const monitor::Stacks& stacks) {
  std::string text;
  for (const monitor::InterruptStackEntry& entry : stacks.interrupts) {
    text += fmt::format("OB {}, priority {}, at {}\n", entry.ob, entry.priority,
                        monitor::toString(entry.place));
    text += registersText(entry.registers);
    text += fmt::format("brackets {}  MCR levels {}\n", entry.brackets.size(), entry.mcr.size());
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
    text += fmt::format("{:>3}  {}  {}  {}\n", line.number, clock, line.eventText, line.text);
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
  text += fmt::format(
      "cycles {}  instructions {}  cycle time last {} ms, shortest {} ms, longest "
      "{} ms\n",
      info.cycles, info.instructions, info.lastCycle, info.shortestCycle, info.longestCycle);
  return text + fmt::format(
                    "blocks {}  load memory {} bytes  work memory {} of {} bytes  local "
                    "data {} bytes\n",
                    info.blocks, info.loadMemory, info.workMemoryUsed, info.workMemory,
                    info.localData);
}

}  // namespace merker::app
