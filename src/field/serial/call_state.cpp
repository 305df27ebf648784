#include "serial/call_state.h"

#include <utility>

namespace merker::serial {
namespace {

constexpr std::size_t kReports = 16;

}  // namespace

// A constant TRUE counts as an edge after each start (PTP-OPEN-10).
void CallState::start() {
  edges_.clear();
  request_ = reset_ = false;
  starting_ = kStartCalls;
  reports_.clear();
}

void CallState::call(std::uint32_t instance, bool request, bool reset) {
  if (starting_ > 0) --starting_;
  Edges& before = edges_[instance];
  if (reset && !before.reset) reset_ = true;
  if (request && !before.request && !reset) request_ = true;
  before = {request, reset};
  for (Report& waiting : reports_)
    if (waiting.calls > 0) --waiting.calls;
}

bool CallState::takeRequest() { return std::exchange(request_, false); }

bool CallState::takeReset() { return std::exchange(reset_, false); }

void CallState::report(const Answer& answer, unsigned calls) {
  if (reports_.size() < kReports) reports_.push_back({answer, calls});
}

std::optional<Answer> CallState::take() {
  if (starting() || reports_.empty() || reports_.front().calls > 0) return std::nullopt;
  const Answer answer = reports_.front().answer;
  reports_.pop_front();
  return answer;
}

}  // namespace merker::serial
