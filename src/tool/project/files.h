// Files of a folder, always in the same order, whatever the file system gives.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/problem.h"

namespace merker::project {

// What is looked at below a folder: files and folders in all, folders within each other.
constexpr std::size_t kMostEntries = 20'000, kDeepestFolder = 32;

// All files under `folder`, relative to it with '/', sorted; without hidden ones, and without
// folders that are projects of their own. P0714, P0715 where a limit leaves some out.
std::vector<std::string> listFiles(const std::string& folder, Problems* problems = nullptr);

// What lies directly in a folder, sorted by name, without hidden files and links to folders (they
// may lead back up).
struct Entry {
  std::string name;
  bool folder = false;
};
std::vector<Entry> entries(const std::string& folder);

bool isFolder(const std::string& path);
bool isFile(const std::string& path);
bool hasExtension(std::string_view path, std::string_view extension);  // ".awl", ignoring case
// "folder/name", just "name" for the folder "." or none.
std::string join(const std::string& folder, const std::string& name);
std::string folderOf(const std::string& path);
std::string stemOf(const std::string& path);

}  // namespace merker::project
