// What SFB 47, 48 and 49 have in common: the channel they work on, and the job interface
// (technology manual 5.5.6, 5.8.2; CNT-JOB, CNT-ERR).
#pragma once

#include "system/arguments.h"
#include "technology/counting.h"
#include "technology/job.h"

namespace merker::system {

// The function of the channel that LADDR and CHANNEL name, as it is now. Null, with JOB_STAT and
// BIE = 0, if it does not exist or is for something else; then nothing else changes (CNT-ERR-07).
technology::Function* openChannel(Arguments& a, std::size_t jobStat);

template <typename Wanted>
Wanted* channelOf(Arguments& a, std::size_t jobStat) {
  constexpr std::uint32_t kWrongMode = 0x8001;
  technology::Function* function = openChannel(a, jobStat);
  if (function == nullptr) return nullptr;
  auto* wanted = dynamic_cast<Wanted*>(function);
  if (wanted != nullptr) return wanted;
  a.set(jobStat, kWrongMode);
  a.fail();
  return nullptr;
}

// LADDR and CHANNEL are the first parameters of all three.
technology::Channel& channelAt(Arguments& a);

// Numbers of the parameters of the job interface.
struct JobParameters {
  std::size_t request, id, value, done, error, status, result;
};

// Runs the job that JOB_REQ asks for with its rising edge; JOB_DONE is 0 in that call
// (CNT-JOB-01 to -04).
template <typename Run>
void runJob(Arguments& a, const JobParameters& p, Run run) {
  technology::Counting::Job& job = a.counting()->job(a.value(1));
  job.done = true;
  if (job.request.rises(a.flag(p.request))) {
    const technology::JobResult result = run(a.value(p.id), a.longInteger(p.value));
    job.done = false;
    job.status = result.error;
    if (result.reads) a.set(p.result, static_cast<std::uint32_t>(result.value));
  }
  a.set(p.done, job.done);
  a.set(p.error, job.status != 0);
  a.set(p.status, job.status);
}

}  // namespace merker::system
