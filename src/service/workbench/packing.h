// The project as a zip: what belongs to it, and what is left out.
#pragma once

#include <stop_token>

#include "archive/file.h"
#include "workbench/method.h"

namespace merker::workbench {

struct Choice {
  Listing files;
  std::set<std::string> left;  // as they may be shown; folders end with '/'
  bool tooMany = false;        // files and folders: there is no zip
};

// Of all that lies in the folder, but hidden files.
Choice choose(const ProjectFolder& folder);

struct Packing {
  std::optional<Problems> wrong;  // there is no zip
  std::shared_ptr<const archive::File> file;
  Json result;  // {name, size, files, left}
};

// All of them into a new folder of the workspace: {folder, files, left}. P1312, P1317.
Answer copyProject(const ProjectFolder& from, const Workspace& workspace, const std::string& name,
                   const std::stop_token& stop);

Packing pack(const ProjectFolder& folder, Choice choice, const std::stop_token& stop);

}  // namespace merker::workbench
