// 28h and 29h: restarts and stop. Functions are named: "P_PROGRAM" is the user program.
#include <optional>
#include <string_view>

#include "base/bytes.h"
#include "s7comm/services.h"

namespace merker::s7comm {
namespace {

constexpr std::string_view kProgram = "P_PROGRAM";

// What Snap7 and STEP 7 look at behind the function.
constexpr std::uint8_t kCannot = 0x02, kAlreadyRuns = 0x03, kAlreadyStopped = 0x07;

// A length of one octet and so many characters, which end the parameters.
std::string_view lastText(View bytes) {
  if (bytes.empty() || bytes.size() - 1 != bytes[0]) return {};
  return {reinterpret_cast<const char*>(bytes.data()) + 1, bytes[0]};
}

struct Invocation {
  std::string_view argument, name;
};

// Function, 6 octets, FD, length of the argument, argument, name.
std::optional<Invocation> invocationOf(View p) {
  constexpr std::size_t kArgument = 10;
  if (p.size() < kArgument) return std::nullopt;
  const std::size_t length = loadWord(&p[8]);
  if (p.size() - kArgument < length) return std::nullopt;
  const View argument = p.subspan(kArgument, length);
  return Invocation{{reinterpret_cast<const char*>(argument.data()), argument.size()},
                    lastText(p.subspan(kArgument + length))};
}

void control(const Job& job, Control wish) {
  job.plc().control(wish, job.password(), [begun = job.begun(), wish](Controlled how) {
    const std::uint8_t already = wish == Control::Stop ? kAlreadyStopped : kAlreadyRuns;
    const std::uint8_t answer[] = {begun.function, how == Controlled::Already ? already : kCannot};
    if (how == Controlled::Done)
      begun.answer(View(answer).first(1));
    else
      begun.answer(answer, {},
                   how == Controlled::Protected ? Error::NeedsPassword : Error::CannotBeDone);
    begun.ended();
  });
}

}  // namespace

void serveProgramInvocation(const Job& job) {
  const auto invocation = invocationOf(job.parameters);
  if (!invocation) return job.refuse(Error::WrongPduSize);
  const auto& [argument, name] = *invocation;
  if (name == kProgram && argument.empty()) return control(job, Control::WarmRestart);
  if (name == kProgram && argument == "C ") return control(job, Control::ColdRestart);
  job.refuse(Error::FunctionNotAvailable);
}

// Function, 5 octets, name.
void serveStop(const Job& job) {
  constexpr std::size_t kName = 6;
  if (job.parameters.size() <= kName) return job.refuse(Error::WrongPduSize);
  if (lastText(job.parameters.subspan(kName)) != kProgram)
    return job.refuse(Error::FunctionNotAvailable);
  control(job, Control::Stop);
}

}  // namespace merker::s7comm
