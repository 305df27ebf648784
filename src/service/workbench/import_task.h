// The import itself, in the thread of a worker: of what a browser has sent, into a new project or
// into the open one.
#pragma once

#include "importing/import.h"
#include "workbench/elsewhere.h"
#include "workbench/upload.h"

namespace merker::workbench {

struct ImportWish {
  std::string name;     // of the new project; empty: into the open one
  std::string program;  // only this one; empty: all
  Encoding codePage = Encoding::Cp437;
  bool listing = false;  // the open project has a SINUMERIK
};

// {programs, name, step5, loose, project}
Answer lookAt(const Upload& upload, const Workspace& workspace, std::optional<bool> listing,
              const std::stop_token& stop);
// {folders, files, lost, report, more}; without a result nothing is left behind.
Answer importNew(const Upload& upload, const Workspace& workspace, const ImportWish& wish,
                 const std::stop_token& stop);
Answer importInto(const Upload& upload, const ProjectFolder& folder, const ImportWish& wish,
                  const std::stop_token& stop);

}  // namespace merker::workbench
