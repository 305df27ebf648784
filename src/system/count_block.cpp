// SFB 47 COUNT (technology manual 5.5.5, 5.10.5; CNT-IF47).
#include "system/technology_block.h"
#include "technology/counter.h"

namespace merker::system {
namespace {

enum {
  LADDR,
  CHANNEL,
  SW_GATE,
  CTRL_DO,
  SET_DO,
  JOB_REQ,
  JOB_ID,
  JOB_VAL,
  STS_GATE,
  STS_STRT,
  STS_LTCH,
  STS_DO,
  STS_C_DN,
  STS_C_UP,
  COUNTVAL,
  LATCHVAL,
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
  STS_ZP,
  JOB_OVAL,
  RES10,
  RES11,
  RES_STS,
  TIMEVAL
};

using technology::Channel;

void show(Arguments& a, const technology::Counter& counter) {
  const Channel& channel = channelAt(a);
  a.set(STS_GATE, counter.gateOpen());
  a.set(STS_STRT, channel.level(Channel::GateInput));
  a.set(STS_LTCH, channel.level(Channel::LatchInput));
  a.set(STS_DO, counter.output());
  a.set(STS_C_DN, counter.down());
  a.set(STS_C_UP, !counter.down());
  a.set(COUNTVAL, static_cast<std::uint32_t>(counter.count()));
  a.set(LATCHVAL, static_cast<std::uint32_t>(counter.latched()));
  a.set(STS_CMP, counter.comparator().reached());
  a.set(STS_OFLW, counter.overflow());
  a.set(STS_UFLW, counter.underflow());
  a.set(STS_ZP, counter.zero());
  if (a.has(TIMEVAL)) a.set(TIMEVAL, counter.period());  // docs/compatibility.md: IDBs of 34 bytes
}

}  // namespace

// Inputs, job, outputs; a reset of the status bits shows in the next call (CNT-JOB-09,
// CNT-IF47-11).
void countBlock(Arguments& a) {
  auto* counter = channelOf<technology::Counter>(a, JOB_STAT);
  if (counter == nullptr) return;
  counter->control(a.flag(SW_GATE), a.flag(CTRL_DO), a.flag(SET_DO), a.machine().clock);
  runJob(a, {JOB_REQ, JOB_ID, JOB_VAL, JOB_DONE, JOB_ERR, JOB_STAT, JOB_OVAL},
         [&](std::uint32_t id, std::int32_t value) { return counter->job(id, value); });
  show(a, *counter);
  if (a.flag(RES_STS)) counter->resetStatus();
}

}  // namespace merker::system
