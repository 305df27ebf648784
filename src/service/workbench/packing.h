// The project as a zip: what belongs to it, and what is left out.
#pragma once

#include <stop_token>

#include "archive/file.h"
#include "workbench/json.h"
#include "workbench/project_folder.h"

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

Packing pack(const ProjectFolder& folder, Choice choice, const std::stop_token& stop);

}  // namespace merker::workbench
