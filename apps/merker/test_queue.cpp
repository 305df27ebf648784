#include "test_queue.h"

#include <algorithm>
#include <thread>

namespace merker::app {

void TestQueue::put(std::size_t number, simulator::TestResult result) {
  const std::lock_guard lock(mutex_);
  results_[number] = std::move(result);
  for (; taken_ < results_.size() && results_[taken_]; ++taken_)
    take_(std::move(*results_[taken_]));
}

void TestQueue::work() {
  for (;;) {
    std::unique_lock lock(mutex_);
    const std::size_t number = begun_++;
    lock.unlock();
    if (number >= tests_.size()) return;
    put(number, tests_[number]());
  }
}

void TestQueue::run() {
  begun_ = taken_ = 0;
  results_.assign(tests_.size(), std::nullopt);
  {
    std::vector<std::jthread> others;
    while (others.size() + 1 < std::min<std::size_t>(threads_, tests_.size()))
      others.emplace_back([this] { work(); });
    work();
  }
  tests_.clear();
}

}  // namespace merker::app
