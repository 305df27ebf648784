// SFB 49 PULSE (technology manual 5.7.2, 5.7.3, 5.10.5; CNT-IF49).
#include "system/technology_block.h"
#include "technology/pulse_width.h"

namespace merker::system {

void pulseBlock(Sfb<49>& a) {
  auto* pulse = functionOf<technology::PulseWidth>(a);
  if (pulse == nullptr) return;
  const Instant now = a.machine().clock;
  pulse->control(a.flag("SW_EN"), a.flag("MAN_DO"), a.flag("SET_DO"), a.integer("OUTP_VAL"), now);
  runJob(a, [&](std::uint32_t id, std::int32_t value) { return pulse->job(id, value, now); });
  a.set("STS_EN", pulse->running());
  showTerminals(a, *pulse);  // brings the channel to now, and forgets what has changed before
  if (pulse->takeChanged()) act(a);
}

}  // namespace merker::system
