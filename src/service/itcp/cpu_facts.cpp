#include "itcp/cpu_facts.h"

#include <fmt/format.h>

#include "catalogue/cpu_model.h"
#include "cpu/led_panel.h"
#include "plc/capability.h"

namespace merker::itcp {
namespace {

// In the order of the front (S7-CPU-31).
constexpr struct {
  std::string_view name, colour;
  cpu::Light cpu::Leds::*light;
} kLeds[] = {{"SF", "red", &cpu::Leds::sf},      {"BF", "red", &cpu::Leds::bf},
             {"BATF", "red", &cpu::Leds::batf},  {"DC5V", "limegreen", &cpu::Leds::dc5v},
             {"FRCE", "gold", &cpu::Leds::frce}, {"RUN", "limegreen", &cpu::Leds::run},
             {"STOP", "gold", &cpu::Leds::stop}};

std::vector<CpuFacts::Led> ledsOf(const controller::Controller& plc) {
  std::vector<CpuFacts::Led> leds;
  const auto* const panel = controller::capability<cpu::LedPanel>(plc);
  if (panel == nullptr) return leds;
  const cpu::Leds all = panel->leds();
  for (const auto& one : kLeds) leds.push_back({one.name, one.colour, all.*one.light});
  return leds;
}

std::vector<CpuFacts::Entry> entriesOf(const monitor::Monitor& monitor) {
  std::vector<CpuFacts::Entry> entries;
  for (const monitor::DiagnosticLine& line : monitor.diagnostics()) {
    if (entries.size() == CpuFacts::kMostEntries) break;
    entries.push_back(
        {line.clock ? monitor::clockText(*line.clock) : "", line.eventText, line.text});
  }
  return entries;
}

}  // namespace

std::string_view nameOf(cpu::Light light) {
  constexpr std::string_view kNames[] = {"off", "on", "0.5 Hz", "2 Hz"};
  return kNames[static_cast<std::size_t>(light)];
}

CpuFacts factsOf(const monitor::Monitor& monitor) {
  const monitor::ModuleInformation info = monitor.information();
  const CpuModel* const model = findCpuModel(info.model);
  return {.model = info.model,
          .orderNumber = model == nullptr ? "" : std::string(model->orderNumber),
          .mode = std::string(monitor::name(info.mode)),
          .stopReason = info.stopReason,
          .clock = info.clock,
          .cycles = info.cycles,
          .lastCycle = info.lastCycle,
          .shortestCycle = info.shortestCycle,
          .longestCycle = info.longestCycle,
          .leds = ledsOf(monitor.plc()),
          .entries = entriesOf(monitor)};
}

}  // namespace merker::itcp
