#include "monitor/module_information.h"

#include <fmt/format.h>

#include "address/constant.h"
#include "block/container.h"
#include "cpu/cpu.h"

namespace merker::monitor {

std::string_view name(station::Mode mode) {
  constexpr std::string_view kNames[] = {"STOP", "STARTUP", "RUN", "HALT"};
  return kNames[static_cast<std::size_t>(mode)];
}

std::string clockText(std::int64_t milliseconds) {
  constexpr std::int64_t kDay = 86'400'000;
  int year = 0, month = 0, day = 0;
  dateFromDays(static_cast<std::uint16_t>(milliseconds / kDay), year, month, day);
  const std::int64_t rest = milliseconds % kDay;
  return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}:{:02}.{:03}", year, month, day,
                     rest / 3'600'000, rest / 60'000 % 60, rest / 1000 % 60, rest % 1000);
}

ModuleInformation moduleInformation(const station::Station& station) {
  const cpu::Cpu& cpu = station.cpu();
  const CpuModel& model = station.model();
  const cpu::CycleTimes& cycle = cpu.cycle().times();
  ModuleInformation info;
  info.model = model.name;
  info.mode = station.mode();
  info.fault = station.stoppedByFault();
  info.stopReason = station.stopReason();
  info.time = station.now();
  info.clock = clockText(cpu.clock().milliseconds(station.now()));
  info.cycles = station.cycles();
  info.instructions = station.instructions();
  info.lastCycle = cycle.previous;
  info.shortestCycle = cycle.shortest;
  info.longestCycle = cycle.longest;
  info.cycleMonitoring = cpu.parameters().cycleMonitoring;
  info.workMemory = model.workMemory;
  info.localData = model.localBytes;
  info.inputs = info.outputs = model.imageBytes;
  info.flags = model.flagBytes;
  info.timers = model.timers;
  info.counters = model.counters;
  info.blocks = station.program().size();
  for (const auto& [id, block] : station.program()) {
    info.loadMemory += static_cast<std::uint32_t>(block::writeContainer(block).size());
    info.workMemoryUsed += static_cast<std::uint32_t>(block.code.size() + block.actualData.size());
  }
  return info;
}

}  // namespace merker::monitor
