// What a browser sends to be imported: files in a temporary folder that is gone with its last user.
// While it is used it is locked, so that one whose process was killed can be told from others.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "base/problem.h"
#include "workbench/descriptor.h"

namespace merker::workbench {

class Upload {
 public:
  static constexpr std::uint64_t kMostBytes = 256u << 20;
  static constexpr std::size_t kMostFiles = 20'000;

  // Null: there is no temporary folder.
  static std::shared_ptr<Upload> make();
  // Deletes what processes of this user that have ended left behind.
  static void sweep();
  ~Upload();
  Upload(const Upload&) = delete;
  Upload& operator=(const Upload&) = delete;

  // To the end of a file, which may be new. P1309, P1313; P1314 beyond a limit.
  std::optional<Problem> add(const std::string& path, std::span<const std::uint8_t> bytes);
  // What is imported: the file, the folder, or all of them.
  std::string source() const;
  std::string name() const;  // of the source, as a project may be named after it
  // A folder beside it for what the import makes.
  std::string output() const { return folder_ + "/output"; }
  bool empty() const { return files_ == 0; }

  // An import looks at the files: nothing may be added. In any thread.
  class Use;
  bool used() const { return uses_ > 0; }

 private:
  Upload(std::string folder, Descriptor lock)
      : folder_(std::move(folder)), lock_(std::move(lock)) {}
  std::string input() const { return folder_ + "/input"; }

  std::string folder_;
  Descriptor lock_;  // of the folder, as long as it is open
  std::uint64_t bytes_ = 0;
  std::size_t files_ = 0;
  std::atomic<int> uses_ = 0;
};

class Upload::Use {
 public:
  explicit Use(std::shared_ptr<Upload> upload) : upload_(std::move(upload)) { ++upload_->uses_; }
  ~Use() { --upload_->uses_; }
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;
  const Upload& operator*() const { return *upload_; }
  const Upload* operator->() const { return upload_.get(); }

 private:
  std::shared_ptr<Upload> upload_;
};

}  // namespace merker::workbench
