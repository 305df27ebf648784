// A foreign project, its archive or single files become Merker projects.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "base/text.h"
#include "importing/report.h"

namespace merker::importing {

struct Options {
  std::string source;
  std::string folder;   // empty: named after the source, in the current folder
  std::string program;  // only this one, by its label or a name that is unique; empty: all
  Encoding codePage = Encoding::Cp437;  // of STEP 5: Cp437 or Cp850
  unsigned page = 0;  // of texts that are not Unicode; 0: what the project names, or by content
  std::stop_token stop{};  // what has been written by then stays
  std::string model{};     // CPU of the project that it goes into; empty: a project of its own
};

enum class Result : std::uint8_t {
  Imported,
  Unreadable,     // the source
  Nothing,        // nothing in it is known
  NoSuchProgram,  // `programs` are there
  Exists,         // the folder
  Unwritable,     // the folder: `report` says why
  Stopped
};

struct Outcome {
  Result result = Result::Imported;
  std::string folder;
  std::vector<std::string> programs;  // what tells them apart
  std::vector<std::string> folders;   // one for each program
  std::string report;                 // also in FOLDER/import-report.txt
  std::vector<Report::Line> lines;    // the same, one by one
  std::vector<std::string> refused;   // why there is nothing: "a.awl: it is encrypted"
  bool lost = false;                  // a block or more did not come
  bool merkerProject = false;         // a program has the merker.toml that it came with
};

Outcome importSource(const Options& options);

}  // namespace merker::importing
