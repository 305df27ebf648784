// F0h: how long a PDU is and how many jobs run at the same time.
#include <algorithm>

#include "base/bytes.h"
#include "s7comm/services.h"

namespace merker::s7comm {
namespace {

constexpr std::size_t kSetupParameters = 8;
constexpr std::uint16_t kShortestPdu = 112;

}  // namespace

void serveSetup(const Job& job) {
  const View p = job.parameters;
  if (p.size() != kSetupParameters) return job.refuse(Error::WrongPduSize);
  const std::uint16_t calling = loadWord(&p[2]), called = loadWord(&p[4]), pdu = loadWord(&p[6]);
  if (pdu < kShortestPdu) return job.refuse(Error::WrongPduSize);
  const auto jobs = [&](std::uint16_t asked) {
    return std::clamp<std::uint16_t>(asked, 1, job.offer().jobs);
  };
  // The answer is an ordinary PDU of at least what was agreed on before.
  job.agree(std::min(pdu, job.offer().pdu), jobs(calling));
  Bytes answer = {job.function, 0};
  appendWord(answer, jobs(calling));
  appendWord(answer, jobs(called));
  appendWord(answer, job.pdu());
  job.answer(answer);
}

}  // namespace merker::s7comm
