// A request whose answer waits for work that is carried out elsewhere.
#pragma once

#include <functional>

#include "workbench/json.h"
#include "workbench/message.h"
#include "workbench/task.h"

namespace merker::workbench {

struct Call;
struct Method;

struct Later {
  Work task;
  // In the PLC's thread, when it is done; may wait for more.
  std::function<Answer(const Call&)> then;
  // Takes the place of what waits like this for the same browser.
  bool newest = false;
};

struct Waiting {
  std::uint64_t browser = 0;
  std::int64_t id = 0;
  Request request;
  const Method* method = nullptr;
  std::uint64_t shown = 0;  // of Shared, when it came
  std::shared_ptr<Later> later;
  bool outdated = false;  // a newer one has taken its place
};

}  // namespace merker::workbench
