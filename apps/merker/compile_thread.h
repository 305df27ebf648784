// A thread that compiles for the workbench, one work after the other, while the PLC goes on.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "workbench/compile_job.h"

namespace merker::app {

class CompileThread {
 public:
  CompileThread();
  // What has begun is finished, what waits is not begun any more.
  ~CompileThread();
  CompileThread(const CompileThread&) = delete;
  CompileThread& operator=(const CompileThread&) = delete;

  void push(workbench::Work work);

 private:
  void run();

  std::mutex mutex_;
  std::condition_variable arrived_;
  std::deque<workbench::Work> waiting_;
  bool ended_ = false;
  std::thread thread_;  // last: it uses the others
};

}  // namespace merker::app
