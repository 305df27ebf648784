#include "monitor/control_monitor.h"

#include <algorithm>

#include "monitor/control_stacks.h"
#include "monitor/control_target.h"
#include "nc/datum.h"
#include "plc/cell_value.h"

namespace merker::monitor {
namespace {

constexpr unsigned kCycleMonitoring = 5;  // MD 5 (S5-MD-01)

CallRaster callRaster(const sinumerik::Plc& plc) {
  const sinumerik::OperatingSystem& os = plc.operatingSystem();
  if (os.schedule().raster().call.ns == 0) return {};  // not started yet
  return {os.schedule().raster().call, os.runTimes().lastRaster, plc.loadPerMille()};
}

}  // namespace

ControlMonitor::ControlMonitor(cnc::Cnc& control, const source::SymbolTable& symbols,
                               simulator::Resolver resolver)
    : Monitor(std::make_unique<ControlTarget>(control), symbols, std::move(resolver)),
      control_(control) {
  control_.plc().onCyclePoint([this](CyclePoint point) { reached(point); });
}

ControlMonitor::~ControlMonitor() { control_.plc().onCyclePoint({}); }

bool ControlMonitor::can(Feature feature) const {
  constexpr Feature kAble[] = {Feature::Breakpoints, Feature::CyclePoints, Feature::Stacks,
                               Feature::Information, Feature::Blocks,      Feature::References,
                               Feature::Engine,      Feature::Symbols,     Feature::Nc};
  return std::ranges::find(kAble, feature) != std::end(kAble);
}

void ControlMonitor::writeInCycle(const address::Reference& reference, const Value& value) {
  const address::Operand& operand = reference.operand;
  const bool input = operand.kind == address::OperandKind::Memory && operand.area == Area::Input;
  if (input && !reference.partner)
    control_.plc().writeImage(reference, value.bits);
  else
    monitor::write(control_, reference, value);
}

void ControlMonitor::stop() { control_.stop(); }  // alarm 6149

Stacks ControlMonitor::stacks() const {
  return controlStacks(std::as_const(control_).plc(), ControlTarget(control_));
}

// Alarms by their number; the PLC has no clock with a date.
std::vector<DiagnosticLine> ControlMonitor::diagnostics() const {
  std::vector<DiagnosticLine> list;
  const auto& all = control_.diagnostics();
  for (auto entry = all.rbegin(); entry != all.rend(); ++entry) {
    DiagnosticLine line;
    line.number = static_cast<unsigned>(list.size()) + 1;
    line.time = entry->time;
    line.event = entry->event;
    if (entry->event != 0) line.eventText = std::to_string(entry->event);
    line.text = entry->text;
    if (list.empty() && entry->event != 0 && control_.mode() == controller::Mode::Stop)
      line.place = debugger().position();
    list.push_back(std::move(line));
  }
  return list;
}

ModuleInformation ControlMonitor::information() const {
  const sinumerik::BlockMemory& blocks = control_.plc().machine().blocks;
  ModuleInformation info;
  info.model = control_.modelName();
  info.mode = control_.mode();
  info.fault = control_.stoppedByFault();
  info.stopReason = control_.stopReason();
  info.time = control_.now();
  info.cycles = control_.cycles();
  info.raster = callRaster(std::as_const(control_).plc());
  info.cycleMonitoring = control_.plc().machineData().word(kCycleMonitoring);
  info.instructions = control_.instructions();
  info.workMemory = 2 * static_cast<std::uint32_t>(blocks.program().size() + blocks.data().size());
  info.workMemoryUsed = 2 * (blocks.programUsed() + blocks.dataUsed());
  info.inputs = info.outputs = sinumerik::kImageBytes;
  info.flags = sinumerik::kFlagBytes;
  info.timers = info.counters = sinumerik::kCells;
  info.blocks = control_.plc().program().size();
  return info;
}

// STEP 5 has formal operands, which are code, and no declared data.
std::vector<FrameVariable> ControlMonitor::variables(std::size_t) const { return {}; }

// A simulated one: E, A and M, see compatibility.md.
bool ControlMonitor::canForce(const address::Reference& reference) const {
  const address::Operand& operand = reference.operand;
  const bool area =
      operand.area == Area::Input || operand.area == Area::Output || operand.area == Area::Flag;
  return reference.nc == 0 && operand.kind == address::OperandKind::Memory && area;
}

bool ControlMonitor::canWrite(const address::Reference& reference) const {
  if (reference.nc != 0) return nc::rowOf(nc::unpack(reference.nc)).put != nullptr;
  if (!monitor::read(control_, reference)) return false;
  return controller::isCell(reference) || control_.whyRefused(reference).empty();
}

bool ControlMonitor::takes(const address::Reference& reference, const Value& value) const {
  return reference.nc == 0 || control_.takes(reference, value.content);
}

bool ControlMonitor::holdsForces() const { return control_.forced(); }

}  // namespace merker::monitor
