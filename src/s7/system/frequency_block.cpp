// SFB 48 FREQUENC (technology manual 5.6.2, 5.10.5; CNT-IF48).
#include "system/technology_block.h"
#include "technology/frequency.h"

namespace merker::system {

void frequencyBlock(Sfb<48>& a) {
  auto* frequency = functionOf<technology::Frequency>(a);
  if (frequency == nullptr) return;
  act(a);
  frequency->control(a.flag("SW_GATE"), a.flag("MAN_DO"), a.flag("SET_DO"), a.machine().clock);
  runJob(a, [&](std::uint32_t id, std::int32_t value) { return frequency->job(id, value); });
  showCount(a, *frequency);
  a.set("MEAS_VAL", static_cast<std::uint32_t>(frequency->value()));
  a.set("STS_CMP", frequency->measured());
  if (a.flag("RES_STS")) frequency->resetStatus();
}

}  // namespace merker::system
