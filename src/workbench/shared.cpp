#include "workbench/shared.h"

#include "project/files.h"

namespace merker::workbench {
namespace {

// A program that is a single file has no folder of its own: only what was read belongs to it.
ProjectFolder folderOf(const project::Project& project) {
  if (project::isFolder(project.path) || project.path.ends_with("merker.toml"))
    return ProjectFolder(project.folder);
  const ProjectFolder all(project.folder);
  std::set<std::string> only;
  for (const auto* list : {&project.sources, &project.otherFiles})
    for (const source::SourceFile& file : *list) only.insert(all.relative(file.name()));
  return ProjectFolder(project.folder, std::move(only));
}

}  // namespace

void Shared::show(std::unique_ptr<Plc> fresh, bool isExample) {
  if (plc && plc->isS7()) engine_ = plc->station()->engine();
  plc = std::move(fresh);
  if (plc && plc->isS7() && engine_) plc->station()->setEngine(*engine_);
  example = isExample;
  pacer.restart();
  breakpoints.clear();
  wantedStatus.clear();
  offline_.reset();
  offlineJob_ = nullptr;
  recorder.stop();
  player.stop();
  ++shown;
  ++programRevision;
  ++filesRevision;
  files = {};
  folder = plc ? folderOf(plc->build().project) : ProjectFolder();
  if (plc) files.look(folder);
  files.loaded();
  if (plc && onCycle) plc->onCycle([this](controller::Controller&) { onCycle(); });
  if (plc && onPoint && plc->isS7()) plc->monitor()->onPoint(onPoint);
}

void Shared::remember(const std::string& opened) {
  constexpr std::size_t kMost = 20;
  std::erase(recent, opened);
  recent.insert(recent.begin(), opened);
  if (recent.size() > kMost) recent.pop_back();
}

void Shared::lookAtFiles() {
  if (plc && files.look(folder)) ++filesRevision;
}

// One job does for all who ask meanwhile.
Job Shared::offlineJob() {
  lookAtFiles();
  if (offline_ && offline_->files == filesRevision) return nullptr;
  if (offlineJob_ && offlineJob_->files() == filesRevision) return offlineJob_;
  offlineJob_ = std::make_shared<CompileJob>(plc->build().project.path,
                                             std::map<std::string, std::string>(), filesRevision);
  work([job = offlineJob_] { job->run(); });
  return offlineJob_;
}

void Shared::take(const Job& job) {
  const bool newer = !offline_ || offline_->files < job->files();
  if (newer) offline_.emplace(std::move(job->result()));
  if (offlineJob_ == job) offlineJob_ = nullptr;
}

void Shared::loaded(compilation::Build build) {
  plc->replace(std::move(build));
  ++programRevision;
  probesWait = true;
}

namespace {

bool isWanted(const monitor::Breakpoint& one, const ProjectFolder& folder,
              const BreakpointLines& wanted) {
  const auto lines = wanted.find(folder.relative(one.place.file));
  return lines != wanted.end() && lines->second.contains(one.place.line);
}

// Until a download is in force only what nobody wants any more is taken away.
void removeBreakpoints(monitor::Debugger& debugger, const ProjectFolder& folder,
                       const BreakpointLines& wanted) {
  const std::vector<monitor::Breakpoint> all = debugger.breakpoints();
  for (const monitor::Breakpoint& one : all)
    if (!isWanted(one, folder, wanted)) debugger.removeBreakpoint(one.number);
}

// Symbols mean what they mean in the program that was loaded.
void placeBreakpoints(monitor::Monitor& monitor, const ProjectFolder& folder,
                      const BreakpointLines& wanted) {
  monitor::Debugger& debugger = monitor.debugger();
  debugger.removeBreakpoints();
  for (const auto& [file, lines] : wanted)
    for (const std::uint32_t line : lines) {
      const auto place =
          monitor::findLocation(std::to_string(line), monitor.locations(folder.full(file)));
      if (place) debugger.setBreakpoint(*place);
    }
}

}  // namespace

void Shared::placeProbes() {
  if (!probesWait || !plc || !plc->isS7()) return;
  const station::Station& station = *plc->station();
  if (station.cpu().program().get() != &station.program())
    return removeBreakpoints(plc->monitor()->debugger(), folder, breakpoints);
  probesWait = false;
  monitor::Debugger& debugger = plc->monitor()->debugger();
  debugger.hideStatus();
  for (const auto& [browser, block] : wantedStatus) debugger.addStatus(block);
  placeBreakpoints(*plc->monitor(), folder, breakpoints);
}

}  // namespace merker::workbench
