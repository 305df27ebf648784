// A thread that works for the workbench while the PLC goes on: one task after the other, the
// browsers in turn.
#pragma once

#include <memory>
#include <string>
#include <thread>

#include "workbench/task.h"

namespace merker::app {

class WorkThread {
 public:
  WorkThread();
  // What has begun is asked to end, what waits is not begun any more. Whoever does not listen is
  // left behind: the program ends all the same.
  ~WorkThread();
  WorkThread(const WorkThread&) = delete;
  WorkThread& operator=(const WorkThread&) = delete;

  void push(workbench::Work work);
  // A thread was left behind: the program must end without its usual cleaning up.
  static bool anyLeftBehind();

 private:
  struct State;
  static void run(const std::shared_ptr<State>& state);

  std::shared_ptr<State> state_;
  std::thread thread_;
};

}  // namespace merker::app
