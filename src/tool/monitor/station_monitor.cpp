#include "monitor/station_monitor.h"

#include "base/text.h"
#include "cpu/cpu.h"
#include "cpu/memory_access.h"
#include "monitor/station_target.h"

namespace merker::monitor {
namespace {

bool isInput(const address::Operand& operand) {
  return operand.kind == address::OperandKind::Memory && operand.area == Area::Input;
}

}  // namespace

StationMonitor::StationMonitor(station::Station& station, const source::SymbolTable& symbols,
                               simulator::Resolver resolver)
    : Monitor(std::make_unique<StationTarget>(station), symbols, std::move(resolver)),
      station_(station) {
  station_.cpu().onCyclePoint([this](CyclePoint point) { reached(point); });
}

StationMonitor::~StationMonitor() { station_.cpu().onCyclePoint({}); }

void StationMonitor::writeInCycle(const address::Reference& reference, const Value& value) {
  const address::Operand& operand = reference.operand;
  if (isInput(operand))
    cpu::write(station_.cpu().machine(), Area::Input, operand.width, operand.value, value.bits);
  else
    monitor::write(station_, reference, value);
}

// 16#4304
void StationMonitor::stop() { station_.cpu().stop(cpu::Event::StopByProgrammer); }

std::string StationMonitor::clock() const {
  return clockText(station_.cpu().clock().milliseconds(station_.now()));
}

void StationMonitor::setClock(std::int64_t milliseconds) { station_.cpu().setClock(milliseconds); }

bool StationMonitor::downloadWaits() const {
  return station_.cpu().program().get() != &station_.program();
}

bool StationMonitor::timersHeld() const { return station_.cpu().timersHeld(); }
void StationMonitor::holdTimers(bool hold) { station_.cpu().holdTimers(hold); }
std::size_t StationMonitor::timers() const { return station_.cpu().machine().timers.size(); }
void StationMonitor::resetTimer(std::size_t number) {
  station_.cpu().machine().timers[number].reset(true);
}

std::optional<CycleTimes> StationMonitor::cycleTimes() const {
  const cpu::CycleTimes& times = station_.cpu().cycle().times();
  return CycleTimes{times.previous, times.shortest, times.longest};
}

std::size_t StationMonitor::diagnosticsAdded() const {
  return station_.cpu().diagnostics().added();
}

Stacks StationMonitor::stacks() const {
  return monitor::stacks(station_.cpu(), station_.program());
}

std::vector<FrameVariable> StationMonitor::variables(std::size_t depth) const {
  return frameVariables(station_.cpu(), depth);
}

// S7-300: E and A of the process image.
bool StationMonitor::canForce(const address::Reference& reference) const {
  const address::Operand& operand = reference.operand;
  return isInput(operand) ||
         (operand.kind == address::OperandKind::Memory && operand.area == Area::Output);
}

bool StationMonitor::canWrite(const address::Reference& reference) const {
  const address::Operand& operand = reference.operand;
  if (station_.isReadOnly(reference)) return false;
  const bool terminal = operand.kind == address::OperandKind::Memory && !reference.outputSide &&
                        (operand.area == Area::Input || operand.area == Area::Peripheral);
  if (!terminal || station_.rack() == nullptr)
    return monitor::read(station_, reference).has_value();
  for (std::uint32_t i = 0; i < byteCount(operand.width); ++i)
    if (!station_.rack()->answersInput(operand.value / 8 + i)) return false;
  return true;
}

bool StationMonitor::holdsForces() const { return !station_.cpu().forces().empty(); }

Result<address::Reference> StationMonitor::local(std::string_view text, const Position& at) const {
  for (const FrameVariable& one : frameVariables(station_.cpu(), 0, SIZE_MAX))
    if (one.operand && equalsIgnoreCase(one.operand->text, text)) return *one.operand;
  return Monitor::local(text, at);
}

}  // namespace merker::monitor
