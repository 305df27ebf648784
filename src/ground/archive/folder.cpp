#include <filesystem>

#include "archive/container.h"

namespace merker::archive {
namespace {

namespace fs = std::filesystem;

class Disk final : public Container {
 public:
  explicit Disk(std::string folder) : folder_(std::move(folder)) {}
  std::unique_ptr<File> open(std::uint64_t, const std::string& path, Refusal& why) override {
    why = Refusal::Unreadable;
    return openFile(folder_ + "/" + path);
  }

 private:
  std::string folder_;
};

}  // namespace

std::shared_ptr<Container> diskContainer(std::string folder) {
  return std::make_shared<Disk>(std::move(folder));
}

void walkFolder(const std::string& folder, unsigned deepest,
                const std::function<bool(const std::string&, std::uint64_t)>& visit,
                const std::function<void(const std::string&, Refusal)>& refuse) {
  std::error_code error;
  // Links to folders are not followed, so no file is met twice.
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && at != fs::recursive_directory_iterator(); at.increment(error)) {
    std::error_code ignored;
    const std::string path = at->path().lexically_relative(folder).generic_string();
    if (at->is_symlink(ignored)) {
      refuse(path, Refusal::Link);
    } else if (at->is_directory(ignored)) {
      if (static_cast<unsigned>(at.depth()) + 1 < deepest) continue;
      refuse(path, Refusal::TooDeep);
      at.disable_recursion_pending();
    } else if (at->is_regular_file(ignored) && !visit(path, at->file_size(ignored))) {
      return;
    }
  }
}

}  // namespace merker::archive
