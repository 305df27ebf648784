// Compiled code between two events (engine.h).
#include <algorithm>

#include "softplc/operating_system.h"

namespace merker::sinumerik {
namespace {

constexpr std::uint8_t kStartUpOb = 20, kAlarmOb = 2;

}  // namespace

// The instant before which an instruction of the running level begins without that step() would do
// something else.
Instant OperatingSystem::horizon(Instant limit) const {
  if (options_.macros != nullptr) limit = std::min(limit, options_.macros->next());
  if (mode_ != Mode::Run) return limit;
  if (watchdog_ != Instant::never()) limit = std::min(limit, watchdog_ + Duration{1});
  limit = std::min(limit, schedule_.next());
  if (alarmLevelRuns() || !active_.bit(data_bit::kChopping)) return limit;
  return std::min(limit, machine_.clock + (shareOfThird() - times_.third));
}

void OperatingSystem::translate() {
  if (options_.engine == nullptr || compiledVersion_ == machine_.blocks.codeVersion()) return;
  compiledVersion_ = machine_.blocks.codeVersion();
  std::vector<bool> apart = recorder_.watched(machine_.blocks);
  if (probes_.any()) probes_.addTo(apart, machine_.blocks);
  options_.engine->compile(machine_, environment_, apart);
}

// Code that writes code is the processor's, and so is every instruction that coverage counts.
bool OperatingSystem::runCompiled(Instant horizon) {
  Engine* const engine = options_.engine;
  if (engine == nullptr || !engine->on || options_.coverage || machine_.blocks.patched())
    return false;
  translate();
  const std::uint8_t ob = machine_.level().ob;
  const Instant before = machine_.clock;
  const std::uint64_t count = engine->run(machine_, horizon);
  if (count == 0) return false;
  processor_.count(count);
  if (ob != kStartUpOb) times_.charge(ob == kAlarmOb, machine_.clock - before);
  return true;
}

}  // namespace merker::sinumerik
