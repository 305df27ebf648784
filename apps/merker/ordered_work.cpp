#include "ordered_work.h"

#include <thread>

namespace merker::app {

OrderedWork::Begun* OrderedWork::withTask() {
  for (const auto& target : begun_)
    if (target->next < target->tasks.size()) return target.get();
  return nullptr;
}

void OrderedWork::prepare(Lock& lock) {
  Begun& target = *begun_.emplace_back(std::make_unique<Begun>());
  const Target& prepare = targets_[prepared_++];
  lock.unlock();
  std::vector<Task> tasks = prepare();
  lock.lock();
  target.words.resize(tasks.size());
  target.tasks = std::move(tasks);
  target.prepared = true;
}

void OrderedWork::runTask(Begun& target, Lock& lock) {
  const std::size_t number = target.next++;
  const Task task = std::move(target.tasks[number]);
  lock.unlock();
  Say words = task();
  lock.lock();
  target.words[number] = std::move(words);
}

void OrderedWork::say() {
  while (!begun_.empty() && begun_.front()->prepared) {
    Begun& target = *begun_.front();
    for (; target.said < target.words.size(); ++target.said) {
      if (!target.words[target.said]) return;
      (*target.words[target.said])();
    }
    begun_.pop_front();
  }
}

// Tasks before new targets: the sooner a target is done, the sooner it is said and forgotten.
void OrderedWork::work() {
  Lock lock(mutex_);
  while (prepared_ < targets_.size() || !begun_.empty()) {
    if (Begun* target = withTask())
      runTask(*target, lock);
    else if (prepared_ < targets_.size() && begun_.size() < 2 * threads_)
      prepare(lock);
    else {
      changed_.wait(lock);
      continue;
    }
    say();
    changed_.notify_all();
  }
}

void OrderedWork::run(std::vector<Target> targets) {
  targets_ = std::move(targets);
  prepared_ = 0;
  std::vector<std::jthread> others;
  while (others.size() + 1 < threads_) others.emplace_back([this] { work(); });
  work();
}

}  // namespace merker::app
