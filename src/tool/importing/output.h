// Files of a new project: never over existing ones, never outside the folder.
#pragma once

#include <set>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>

#include "importing/report.h"

namespace merker::importing {

class Output {
 public:
  Output(std::string folder, Report& report, std::stop_token stop = {})
      : folder_(std::move(folder)), report_(report), stop_(std::move(stop)) {}

  // Nobody waits for the import any more.
  bool stopped() const { return stop_.stop_requested(); }

  // `name` may contain a folder: "sources/Main.txt". False, and a note, if it is there already.
  bool write(const std::string& name, std::string_view text);
  bool write(const std::string& name, std::span<const std::uint8_t> bytes);
  const std::string& folder() const { return folder_; }

  // A name for a file or folder that is not used yet: letters, digits and what is harmless
  // everywhere. `extension` with its point.
  std::string unused(std::string_view wanted, std::string_view extension);

 private:
  std::string folder_;
  Report& report_;
  std::stop_token stop_;
  std::set<std::string> used_;  // without case
};

// "plant" for "/old/plant.zip".
std::string stemOf(const std::string& source);

// Makes the folder. Why no file can be made in it; empty if one can.
std::string whyNotWritable(const std::string& folder);

// Whether there is nothing at this path, or an empty folder.
bool isFree(const std::string& path);

}  // namespace merker::importing
