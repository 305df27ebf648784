// The breakpoints of browsers at the PLC. Those that others have set there, clients of S7
// communication, stay.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "monitor/monitor.h"
#include "workbench/project_folder.h"

namespace merker::workbench {

// Lines with breakpoints by file, relative to the project folder.
using BreakpointLines = std::map<std::string, std::set<std::uint32_t>>;

class PageBreakpoints {
 public:
  bool are(const BreakpointLines& wanted) const { return lines_ == wanted; }
  // Symbols mean what they mean in the program that was loaded.
  void place(monitor::Monitor& monitor, const ProjectFolder& folder, const BreakpointLines& wanted);
  // Until a download takes effect: no new ones, and none that are no longer wanted.
  void keep(monitor::Debugger& debugger, const ProjectFolder& folder,
            const BreakpointLines& wanted);

 private:
  std::set<unsigned> numbers_;  // of the debugger
  BreakpointLines lines_;
};

}  // namespace merker::workbench
