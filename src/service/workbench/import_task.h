// The import itself, in the thread of a worker: of what a browser has sent, into a new project or
// into the open one.
#pragma once

#include "importing/import.h"
#include "workbench/elsewhere.h"
#include "workbench/upload.h"

namespace merker::workbench {

// The project that is open, as far as an import has to know it.
struct OpenProject {
  std::string path;      // as `merker check` gets it
  std::string model;     // the keyword of its CPU
  bool listing = false;  // a SINUMERIK's
  bool growing = false;  // it has a folder that files can be added to
};

struct ImportWish {
  std::string name;     // of the new project; empty: into the open one
  std::string program;  // only this one; empty: all
  unsigned page = 0;    // of texts; 0: as the source says or by their content
  OpenProject open;
};

// {programs, name, step7, step5, loose}
Answer lookAt(const Upload& upload, const Workspace& workspace,
              const std::optional<OpenProject>& open, const std::stop_token& stop);
// {folders, files, lost, report, more}; without a result nothing is left behind.
Answer importNew(const Upload& upload, const Workspace& workspace, const ImportWish& wish,
                 const std::stop_token& stop);
Answer importInto(const Upload& upload, const ProjectFolder& folder, const ImportWish& wish,
                  const std::stop_token& stop);

}  // namespace merker::workbench
