// Work of two steps on several threads: a target is prepared, then its tasks run. What they say
// comes in the order of the targets, as soon as everything before it was said.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace merker::app {

class OrderedWork {
 public:
  using Say = std::function<void()>;  // called by one thread at a time
  using Task = std::function<Say()>;
  using Target = std::function<std::vector<Task>()>;

  explicit OrderedWork(unsigned threads) : threads_(threads) {}
  // Returns when all was said. At most two targets for each thread are held at a time.
  void run(std::vector<Target> targets);

 private:
  struct Begun {
    bool prepared = false;
    std::vector<Task> tasks;
    std::size_t next = 0, said = 0;  // tasks begun; tasks whose words were said
    std::vector<std::optional<Say>> words;
  };
  using Lock = std::unique_lock<std::mutex>;

  void work();
  Begun* withTask();
  void prepare(Lock& lock);
  void runTask(Begun& target, Lock& lock);
  void say();

  unsigned threads_;
  std::vector<Target> targets_;
  std::mutex mutex_;  // of what follows
  std::condition_variable changed_;
  std::size_t prepared_ = 0;                  // targets whose preparation began
  std::deque<std::unique_ptr<Begun>> begun_;  // not all said yet, in their order
};

}  // namespace merker::app
