// What SFB 47, 48 and 49 have in common: the channel they work on, the job interface, and results
// (technology manual 5.5.6, 5.8.2; CNT-JOB, CNT-ERR).
#pragma once

#include "system/call.h"
#include "technology/counting.h"
#include "technology/job.h"

namespace merker::system {

constexpr std::uint32_t kWrongMode = 0x8001, kNoChannel = 0x8009;

// 0, or the JOB_STAT that says why there is no such channel, or why it has no function.
std::uint32_t openChannel(Arguments& a, std::uint32_t address, std::int32_t channel);

// The call has changed the channel: outputs and interrupts follow at the end of the instruction.
void act(Arguments& a);

template <typename A>
technology::Channel& channelOf(A& a) {
  return a.counting()->at(a.value("CHANNEL"), a.machine().clock);
}

// The function of the channel that LADDR and CHANNEL name, as it is now. Null, with JOB_STAT and
// BIE = 0, if it does not exist or is for something else; then nothing else changes (CNT-ERR-07).
template <typename Wanted, typename A>
Wanted* functionOf(A& a) {
  std::uint32_t error = openChannel(a, a.value("LADDR"), a.integer("CHANNEL"));
  if (error == 0) {
    if (auto* wanted = dynamic_cast<Wanted*>(channelOf(a).function())) return wanted;
    error = kWrongMode;
  }
  a.set("JOB_STAT", error);
  a.fail();
  return nullptr;
}

// Runs the job that JOB_REQ asks for with its rising edge; JOB_DONE is 0 in that call
// (CNT-JOB-01 to -04).
template <typename A, typename Run>
void runJob(A& a, Run run) {
  technology::Counting::Job& job = a.counting()->job(a.value("CHANNEL"));
  job.done = true;
  if (job.request.rises(a.flag("JOB_REQ"))) {
    const technology::JobResult result = run(a.value("JOB_ID"), a.longInteger("JOB_VAL"));
    job.done = false;
    job.status = result.error;
    if (result.reads) a.set("JOB_OVAL", static_cast<std::uint32_t>(result.value));
  }
  a.set("JOB_DONE", job.done);
  a.set("JOB_ERR", job.status != 0);
  a.set("JOB_STAT", job.status);
}

template <typename A, typename Function>
void showTerminals(A& a, const Function& function) {
  a.set("STS_STRT", channelOf(a).level(technology::Channel::GateInput));
  a.set("STS_DO", function.output());
}

// Of SFB 47 and 48.
template <typename A, typename Function>
void showCount(A& a, const Function& function) {
  showTerminals(a, function);
  a.set("STS_GATE", function.gateOpen());
  a.set("STS_C_DN", function.down());
  a.set("STS_C_UP", !function.down());
  a.set("COUNTVAL", static_cast<std::uint32_t>(function.count()));
  a.set("STS_OFLW", function.overflow());
  a.set("STS_UFLW", function.underflow());
}

}  // namespace merker::system
