// What an import has made goes into the open project: nothing there is replaced, merker.toml lists
// what it has to list.
#pragma once

#include "importing/import.h"
#include "workbench/import_task.h"

namespace merker::workbench {

class Addition {
 public:
  Addition(const ProjectFolder& to, const ProjectFolder& made, const OpenProject& open)
      : to_(to), made_(made), open_(open) {}

  // All files; each has its line in the report. False: it was stopped, and nothing is left.
  bool add(std::vector<importing::Report::Line>& lines, const std::stop_token& stop);
  const std::vector<std::string>& files() const { return files_; }  // that are there now

 private:
  std::optional<std::string> whyNot(const std::string& path);
  void list(std::vector<importing::Report::Line>& lines, const std::stop_token& stop) const;
  void check(std::vector<importing::Report::Line>& lines, const std::stop_token& stop) const;

  const ProjectFolder& to_;
  const ProjectFolder& made_;
  const OpenProject& open_;
  std::map<std::string, std::string> there_;  // in capital letters: as it is written
  std::vector<std::string> files_;
};

}  // namespace merker::workbench
