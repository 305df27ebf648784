// A compilation that may be carried out elsewhere while the PLC goes on.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "workbench/offline.h"

namespace merker::workbench {

using Work = std::function<void()>;
// Who carries work out, some time and in some thread; one after the other.
using Worker = std::function<void(Work)>;

class CompileJob {
 public:
  // `unsaved`: texts in place of files, by their full paths. `files`: revision of the folder.
  CompileJob(std::string project, std::map<std::string, std::string> unsaved, std::uint64_t files)
      : project_(std::move(project)), unsaved_(std::move(unsaved)), files_(files) {}

  void run();  // once
  bool done() const { return done_.load(std::memory_order_acquire); }
  std::uint64_t files() const { return files_; }
  Offline& result() { return *result_; }  // when it is done

 private:
  std::string project_;
  std::map<std::string, std::string> unsaved_;
  std::uint64_t files_;
  std::optional<Offline> result_;
  std::atomic<bool> done_ = false;
};

using Job = std::shared_ptr<CompileJob>;

}  // namespace merker::workbench
