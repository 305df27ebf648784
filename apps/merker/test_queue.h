// Tests that know nothing of each other, on several threads; their results in their order.
#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "scenario/test_result.h"

namespace merker::app {

class TestQueue {
 public:
  using Test = std::function<simulator::TestResult()>;
  // Called by one thread at a time.
  using Take = std::function<void(simulator::TestResult)>;

  TestQueue(unsigned threads, Take take) : threads_(threads), take_(std::move(take)) {}
  void add(Test test) { tests_.push_back(std::move(test)); }
  // Runs what was added, and forgets it; each result is taken as soon as those before it were.
  void run();

 private:
  void work();
  void put(std::size_t number, simulator::TestResult result);

  unsigned threads_;
  Take take_;
  std::vector<Test> tests_;
  std::mutex mutex_;  // of what follows
  std::size_t begun_ = 0, taken_ = 0;
  std::vector<std::optional<simulator::TestResult>> results_;
};

}  // namespace merker::app
