// SFB 48 FREQUENC (technology manual 5.6.2, 5.10.5; CNT-IF48).
#include "system/technology_block.h"
#include "technology/frequency.h"

namespace merker::system {
namespace {

enum {
  LADDR,
  CHANNEL,
  SW_GATE,
  MAN_DO,
  SET_DO,
  JOB_REQ,
  JOB_ID,
  JOB_VAL,
  STS_GATE,
  STS_STRT,
  STS_DO,
  STS_C_DN,
  STS_C_UP,
  MEAS_VAL,
  COUNTVAL,
  JOB_DONE,
  JOB_ERR,
  JOB_STAT,
  RES00,
  RES01,
  RES02,
  STS_CMP,
  RES04,
  STS_OFLW,
  STS_UFLW,
  JOB_OVAL,
  RES10,
  RES11,
  RES_STS
};

using technology::Channel;

void show(Arguments& a, const technology::Frequency& frequency) {
  a.set(STS_GATE, frequency.gateOpen());
  a.set(STS_STRT, channelAt(a).level(Channel::GateInput));
  a.set(STS_DO, frequency.output());
  a.set(STS_C_DN, frequency.down());
  a.set(STS_C_UP, !frequency.down());
  a.set(MEAS_VAL, static_cast<std::uint32_t>(frequency.value()));
  a.set(COUNTVAL, static_cast<std::uint32_t>(frequency.count()));
  a.set(STS_CMP, frequency.measured());
  a.set(STS_OFLW, frequency.overflow());
  a.set(STS_UFLW, frequency.underflow());
}

}  // namespace

void frequencyBlock(Arguments& a) {
  auto* frequency = channelOf<technology::Frequency>(a, JOB_STAT);
  if (frequency == nullptr) return;
  frequency->control(a.flag(SW_GATE), a.flag(MAN_DO), a.flag(SET_DO), a.machine().clock);
  runJob(a, {JOB_REQ, JOB_ID, JOB_VAL, JOB_DONE, JOB_ERR, JOB_STAT, JOB_OVAL},
         [&](std::uint32_t id, std::int32_t value) { return frequency->job(id, value); });
  show(a, *frequency);
  if (a.flag(RES_STS)) frequency->resetStatus();
}

}  // namespace merker::system
