#include "compile_thread.h"

namespace merker::app {

CompileThread::CompileThread() : thread_([this] { run(); }) {}

CompileThread::~CompileThread() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  arrived_.notify_one();
  thread_.join();
}

void CompileThread::push(workbench::Work work) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(work));
  }
  arrived_.notify_one();
}

void CompileThread::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    arrived_.wait(lock, [this] { return ended_ || !waiting_.empty(); });
    if (ended_) return;
    const workbench::Work work = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    work();
    lock.lock();
  }
}

}  // namespace merker::app
