// What an import would find, without importing it.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

namespace merker::importing {

struct Contents {
  bool readable = false;
  // Of STEP 7, STEP 5 and Merker: each becomes a project. What tells them apart.
  std::vector<std::string> programs;
  bool step7 = false, step5 = false;  // of what families they and the single files are
  bool whole = false;                 // a project of STEP 7 or Merker, or a station: no loose files
  std::vector<std::string> refused;   // "a.awl: it is encrypted"
  bool empty() const { return programs.empty() && !step7 && !step5; }
};

Contents look(const std::string& source, const std::stop_token& stop);

}  // namespace merker::importing
