#include "archive/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

namespace merker::archive {
namespace {

class DiskFile final : public File {
 public:
  explicit DiskFile(Handle handle) : handle_(std::move(handle)) {
    struct stat status {};
    if (fstat(fileno(handle_.get()), &status) == 0)
      size_ = static_cast<std::uint64_t>(status.st_size);
  }
  std::uint64_t size() const override { return size_; }
  std::size_t read(std::uint64_t at, std::span<std::uint8_t> to) const override {
    std::size_t got = 0;
    while (got < to.size()) {
      const ssize_t count = pread(fileno(handle_.get()), to.data() + got, to.size() - got,
                                  static_cast<off_t>(at + got));
      if (count <= 0) break;
      got += static_cast<std::size_t>(count);
    }
    return got;
  }

 private:
  Handle handle_;
  std::uint64_t size_ = 0;
};

class MemoryFile final : public File {
 public:
  explicit MemoryFile(std::vector<std::uint8_t> bytes) : bytes_(std::move(bytes)) {}
  std::uint64_t size() const override { return bytes_.size(); }
  std::size_t read(std::uint64_t at, std::span<std::uint8_t> to) const override {
    if (at >= bytes_.size()) return 0;
    const std::size_t count = std::min<std::size_t>(to.size(), bytes_.size() - at);
    std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(at), count, to.begin());
    return count;
  }

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace

std::string File::text(std::size_t most) const {
  std::string out(static_cast<std::size_t>(std::min<std::uint64_t>(size(), most)), '\0');
  out.resize(read(0, {reinterpret_cast<std::uint8_t*>(out.data()), out.size()}));
  return out;
}

std::unique_ptr<File> openFile(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return nullptr;
  struct stat status {};
  if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
    close(descriptor);
    return nullptr;
  }
  return fileOn(Handle(fdopen(descriptor, "rb")));
}

std::unique_ptr<File> fileOn(Handle handle) {
  return handle ? std::make_unique<DiskFile>(std::move(handle)) : nullptr;
}

std::unique_ptr<File> fileOf(std::vector<std::uint8_t> bytes) {
  return std::make_unique<MemoryFile>(std::move(bytes));
}

}  // namespace merker::archive
