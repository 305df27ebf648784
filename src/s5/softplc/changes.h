// What waits for the end of the cycle: blocks move between two cycles only.
#pragma once

#include <functional>
#include <utility>
#include <vector>

namespace merker::sinumerik {

class Changes {
 public:
  void add(std::function<void()> change) { waiting_.push_back(std::move(change)); }
  bool empty() const { return waiting_.empty(); }
  // In the order in which they came; one that comes meanwhile waits for the next call.
  void carryOut() {
    const auto changes = std::exchange(waiting_, {});
    for (const auto& change : changes) change();
  }

 private:
  std::vector<std::function<void()>> waiting_;
};

}  // namespace merker::sinumerik
