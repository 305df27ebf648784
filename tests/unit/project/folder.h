// A folder of its own for one test, gone afterwards.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace merker::project {

class Folder {
 public:
  Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "merker-XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  ~Folder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  // Writes a file with its folders; its path.
  std::string write(const std::string& name, const std::string& text = "") const {
    const std::filesystem::path file = std::filesystem::path(path_) / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file.string();
  }
  const std::string& path() const { return path_; }
  // `text` without the path of this folder in front.
  std::string inside(const std::string& text) const {
    return text.starts_with(path_) ? text.substr(std::min(path_.size() + 1, text.size())) : text;
  }

 private:
  std::string path_;
};

}  // namespace merker::project
