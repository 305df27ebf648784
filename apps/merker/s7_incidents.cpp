#include "s7_incidents.h"

#include <algorithm>

namespace merker::app {
namespace {

struct WhyRow {
  const char* code;  // docs/workbench-protocol.md, S7Refusal
  std::atomic<std::uint64_t> S7Counts::*counter;
};

// In the order of S7Why.
constexpr WhyRow kWhyRows[] = {
    {"resource", &S7Counts::refused},  {"slot", &S7Counts::refused},
    {"socket", &S7Counts::refused},    {"power", &S7Counts::refused},
    {"way", &S7Counts::refused},       {"transport", &S7Counts::broken},
    {"protocol", &S7Counts::broken},   {"late", &S7Counts::broken},
    {"unread", &S7Counts::broken},     {"room", &S7Counts::broken},
    {"protection", &S7Counts::denied}, {"password", &S7Counts::denied},
    {"setup", &S7Counts::denied},
};

}  // namespace

void S7Incidents::note(const std::string& address, S7Why why, Clock::time_point now) {
  ++(counts.*kWhyRows[static_cast<std::size_t>(why)].counter);
  const auto known = std::ranges::find_if(
      incidents_, [&](const Incident& one) { return one.address == address && one.why == why; });
  Incident one{address, why};
  if (known != incidents_.end()) one = *known, incidents_.erase(known);
  ++one.times;
  one.last = now;
  incidents_.push_front(std::move(one));
  if (incidents_.size() > kMost) incidents_.pop_back();
}

std::vector<workbench::S7RefusedRow> S7Incidents::rows(Clock::time_point now) const {
  std::vector<workbench::S7RefusedRow> rows;
  for (const Incident& one : incidents_)
    rows.push_back({one.address, kWhyRows[static_cast<std::size_t>(one.why)].code, one.times,
                    std::chrono::duration_cast<std::chrono::seconds>(now - one.last).count()});
  return rows;
}

}  // namespace merker::app
