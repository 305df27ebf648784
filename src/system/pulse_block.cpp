// SFB 49 PULSE (technology manual 5.7.2, 5.7.3, 5.10.5; CNT-IF49).
#include "system/technology_block.h"
#include "technology/pulse_width.h"

namespace merker::system {
namespace {

enum {
  LADDR,
  CHANNEL,
  SW_EN,
  MAN_DO,
  SET_DO,
  OUTP_VAL,
  JOB_REQ,
  JOB_ID,
  JOB_VAL,
  STS_EN,
  STS_STRT,
  STS_DO,
  JOB_DONE,
  JOB_ERR,
  JOB_STAT,
  JOB_OVAL
};

}  // namespace

void pulseBlock(Arguments& a) {
  auto* pulse = channelOf<technology::PulseWidth>(a, JOB_STAT);
  if (pulse == nullptr) return;
  const Instant now = a.machine().clock;
  pulse->control(a.flag(SW_EN), a.flag(MAN_DO), a.flag(SET_DO), a.integer(OUTP_VAL), now);
  runJob(a, {JOB_REQ, JOB_ID, JOB_VAL, JOB_DONE, JOB_ERR, JOB_STAT, JOB_OVAL},
         [&](std::uint32_t id, std::int32_t value) { return pulse->job(id, value, now); });
  a.set(STS_EN, pulse->running());
  a.set(STS_STRT, channelAt(a).level(technology::Channel::GateInput));
  a.set(STS_DO, pulse->output());
}

}  // namespace merker::system
