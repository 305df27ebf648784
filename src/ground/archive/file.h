// One open file, read at any place.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace merker::archive {

class File {
 public:
  virtual ~File() = default;
  virtual std::uint64_t size() const = 0;
  // Fills `to` from offset `at` on; the number of bytes that were there.
  virtual std::size_t read(std::uint64_t at, std::span<std::uint8_t> to) const = 0;

  // The whole file, or what there is of its first `most` bytes.
  std::string text(std::size_t most) const;
};

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using Handle = std::unique_ptr<std::FILE, Close>;

// Null if there is no such regular file, or it cannot be read.
std::unique_ptr<File> openFile(const std::string& path);
std::unique_ptr<File> fileOn(Handle handle);
std::unique_ptr<File> fileOf(std::vector<std::uint8_t> bytes);

}  // namespace merker::archive
