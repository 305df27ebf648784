// One step of the running level, by the processor or by compiled code up to the next event.
#include <algorithm>

#include "softplc/operating_system.h"

namespace merker::sinumerik {
namespace {

constexpr std::uint8_t kStartUpOb = 20;

}  // namespace

// When chopping, OB 1 rests once it has had its share of a third of the raster (S5-SCHED-06).
bool OperatingSystem::executable() const {
  if (machine_.levels.empty()) return false;
  if (alarmLevel_.runs() || !active_.bit(data_bit::kChopping)) return true;
  return times_.third < shareOfThird();
}
Duration OperatingSystem::shareOfThird() const {
  return {schedule_.raster().call.ns / 3 * active_.word(1) / 100};
}

void OperatingSystem::execute(Instant limit) {
  if (runCompiled(horizon(limit))) return;
  if (probes_.any() && probes_.before(machine_)) return static_cast<void>(hold());
  const std::uint8_t ob = machine_.level().ob;
  const Instant before = machine_.clock;
  const bool stpBefore = processor_.stpSeen();
  if (recorder_.active()) recorder_.beforeStep(machine_);
  const Outcome outcome = processor_.step();
  if (recorder_.active()) recorder_.afterStep(processor_, outcome);
  if (probes_.any()) probes_.after(processor_, outcome);
  if (outcome == Outcome::Trapped) return raise(processor_.trap());
  if (processor_.stpSeen() && !stpBefore) record_.keepPicture();
  charge(ob, machine_.clock - before);
  if (outcome == Outcome::LevelEnded && mode() != Mode::Stop) levelEnded(ob);
}

void OperatingSystem::charge(std::uint8_t ob, Duration time) {
  if (ob != kStartUpOb) times_.charge(ob == kAlarmOb, time);
}

// The instant before which an instruction of the running level begins without that step() would do
// something else.
Instant OperatingSystem::horizon(Instant limit) const {
  if (options_.macros != nullptr) limit = std::min(limit, options_.macros->next());
  if (mode() != Mode::Run) return limit;
  limit = std::min({limit, watch_.overdue(), schedule_.next()});
  if (alarmLevel_.runs() || !active_.bit(data_bit::kChopping)) return limit;
  return std::min(limit, machine_.clock + (shareOfThird() - times_.third));
}

bool OperatingSystem::runCompiled(Instant horizon) {
  const std::uint8_t ob = machine_.level().ob;
  const Instant before = machine_.clock;
  const std::uint64_t count = compiled_.run(horizon);
  if (count == 0) return false;
  processor_.count(count);
  charge(ob, machine_.clock - before);
  return true;
}

}  // namespace merker::sinumerik
