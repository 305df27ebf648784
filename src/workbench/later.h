// A request whose answer waits for a compilation.
#pragma once

#include <functional>

#include "workbench/compile_job.h"
#include "workbench/json.h"

namespace merker::workbench {

struct Call;
struct Method;

struct Later {
  Job job;
  std::function<Answer(const Call&, Offline&)> then;
};

struct Waiting {
  std::uint64_t browser = 0;
  Json request;
  const Method* method = nullptr;
  std::uint64_t shown = 0;  // of Shared, when it came
  std::shared_ptr<Later> later;
};

}  // namespace merker::workbench
