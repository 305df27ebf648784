#include "workbench/page_breakpoints.h"

namespace merker::workbench {
namespace {

bool isWanted(const monitor::Breakpoint& one, const ProjectFolder& folder,
              const BreakpointLines& wanted) {
  const auto lines = wanted.find(folder.relative(one.place.file));
  return lines != wanted.end() && lines->second.contains(one.place.line);
}

}  // namespace

void PageBreakpoints::keep(monitor::Debugger& debugger, const ProjectFolder& folder,
                           const BreakpointLines& wanted) {
  const std::vector<monitor::Breakpoint> all = debugger.breakpoints();
  for (const monitor::Breakpoint& one : all)
    if (numbers_.contains(one.number) && !isWanted(one, folder, wanted))
      debugger.removeBreakpoint(one.number);
}

void PageBreakpoints::place(monitor::Monitor& monitor, const ProjectFolder& folder,
                            const BreakpointLines& wanted) {
  monitor::Debugger& debugger = monitor.debugger();
  for (const unsigned number : std::exchange(numbers_, {})) debugger.removeBreakpoint(number);
  lines_ = wanted;
  for (const auto& [file, lines] : wanted)
    for (const std::uint32_t line : lines) {
      const auto place =
          monitor::findLocation(std::to_string(line), monitor.locations(folder.full(file)));
      if (place) numbers_.insert(debugger.setBreakpoint(*place).number);
    }
}

}  // namespace merker::workbench
