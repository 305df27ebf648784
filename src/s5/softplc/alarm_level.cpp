#include "softplc/alarm_level.h"

#include <utility>

#include "softplc/periphery_check.h"

namespace merker::sinumerik {

AlarmLevel::AlarmLevel(Processor& processor, TransferFlags& flags, RunTimes& times,
                       const Surroundings& around)
    : processor_(processor), flags_(flags), times_(times), around_(around) {}

void AlarmLevel::watch(unsigned byte) {
  byte_ = byte;
  input_.begin(processor_.machine().periphery.inputs[byte], isDistributed(around_.modules, byte)
                                                                ? AlarmInput::kDistributed
                                                                : AlarmInput::kCentral);
}

void AlarmLevel::terminalChanged(unsigned byte, std::uint8_t value) {
  if (byte == byte_) input_.change(value, processor_.machine().clock);
}

std::optional<Trap> AlarmLevel::sample(Instant at) {
  const Edges edges = input_.sample(at);
  if (!edges.any()) return std::nullopt;
  if (!runs()) return begin(edges);
  waiting_.negative = static_cast<std::uint8_t>(waiting_.negative | edges.negative);
  waiting_.positive = static_cast<std::uint8_t>(waiting_.positive | edges.positive);
  return Trap{Alarm::ProcessingDelay, {kAlarmOb, 0, 0}};
}

std::optional<Trap> AlarmLevel::begin(Edges edges) {
  if (processor_.machine().levels.size() >= kInterruptDepth) return Trap{Alarm::InterruptStack, {}};
  if (!processor_.begin(kAlarmOb)) return Trap{Alarm::MissingBlock, {0, 0, kAlarmOb}};
  flags_.enterLevel(kAlarmOb, around_);
  flags_.showEdges(edges);
  ++times_.cycle.alarmRuns;
  return std::nullopt;
}

void AlarmLevel::end() {
  flags_.showEdges({});
  flags_.levelComplete(kAlarmOb);
  Machine& machine = processor_.machine();
  if (!machine.levels.empty()) flags_.resumeLevel(machine.level().ob);
}

std::optional<Trap> AlarmLevel::beginWaiting() {
  const Edges waiting = std::exchange(waiting_, {});
  return waiting.any() ? begin(waiting) : std::nullopt;
}

void AlarmLevel::sampled(Duration limit) {
  if (times_.alarmWindow() <= limit) reported_ = false;
}

bool AlarmLevel::exceeds(Duration limit) {
  return times_.alarmWindow() > limit && !std::exchange(reported_, true);
}

}  // namespace merker::sinumerik
