// Functions that take more than one call (BUSY): the first call with REQ = 1 begins the job, a
// later call with the same parameters ends it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace merker::system {

struct Job {
  std::uint16_t function = 0;
  std::uint32_t target = 0;  // module or partner
  std::uint32_t number = 0;  // of the data record
  bool operator==(const Job&) const = default;
};

class Jobs {
 public:
  static constexpr std::size_t kMost = 4;  // at the same time: docs/compatibility.md

  bool full() const { return jobs_.size() >= kMost; }
  void begin(const Job& job) { jobs_.push_back(job); }
  // True if it was running; it is then over.
  bool end(const Job& job) {
    const auto at = std::find(jobs_.begin(), jobs_.end(), job);
    if (at == jobs_.end()) return false;
    jobs_.erase(at);
    return true;
  }
  void clear() { jobs_.clear(); }

 private:
  std::vector<Job> jobs_;
};

constexpr std::uint32_t kNoJob = 0x7000, kJobBegins = 0x7001;

// Ends a call: BUSY says whether the job goes on.
template <typename A>
void answerJob(A& a, std::uint32_t code) {
  a.set("BUSY", code == kJobBegins);
  a.status(code);
}

}  // namespace merker::system
