#include "workbench/shared.h"

#include "plc/machine_code.h"
#include "project/files.h"

namespace merker::workbench {

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

void Shared::show(std::shared_ptr<Plc> fresh, bool isExample, Listing seen) {
  engine_ = engine();
  discard(std::exchange(lab, nullptr));
  exchange(std::move(fresh));
  example = isExample;
  take(nextLook(), std::move(seen));
  files.loaded();
}

void Shared::show(std::shared_ptr<Laboratory> fresh, std::size_t first, bool isExample,
                  Listing seen) {
  show(std::shared_ptr<Plc>(fresh, fresh->plcs[first].get()), isExample, std::move(seen));
  lab = std::move(fresh);
  station = first;
}

void Shared::showStation(std::size_t number) {
  if (number == station) return;
  station = number;
  leave();
  const Pace kept = pacer.pace();
  exchange(std::shared_ptr<Plc>(lab, lab->plcs[number].get()));
  pacer.set(kept);
  take(nextLook(), folder.list());
  files.loaded();
}

// Nobody looks at it any more, and it goes on: without breakpoints, not in HALT.
void Shared::leave() {
  monitor::Debugger& debugger = plc->monitor().debugger();
  placed_.place(plc->monitor(), folder, {});
  debugger.keepStatus([](const auto&) { return false; });
  if (plc->controller().mode() == controller::Mode::Halt) debugger.run(plc->controller().now(), {});
}

void Shared::exchange(std::shared_ptr<Plc> fresh) {
  dropWorks();
  discard(std::exchange(plc, std::move(fresh)));
  pacer.restart();
  breakpoints.clear();
  placed_ = {};
  wantedStatus.clear();
  stepEnds.reset();
  discard(std::exchange(offline_, nullptr));
  offlineJob_ = nullptr;
  recorder.stop();
  player.stop();
  serialView = {};
  ++shown;
  ++programRevision;
  ++filesRevision;
  files = {};
  folder = plc ? folderOf(plc->build().project) : ProjectFolder();
  lookTask_ = nullptr;
  if (!plc || !plc->attach()) return;
  const Plc* const here = plc.get();
  if (onCycle)
    plc->onCycle([this, here](controller::Controller&) {
      if (plc.get() == here) onCycle();
    });
  if (onPoint)
    plc->monitor().onPoint([this, here](monitor::CyclePoint point) {
      if (plc.get() == here) onPoint(point);
    });
}

std::optional<station::Engine> Shared::engine() const {
  const auto* code =
      plc ? controller::capability<controller::MachineCode>(plc->controller()) : nullptr;
  if (code == nullptr) return engine_;
  return code->compiled() ? station::Engine::Compiled : station::Engine::Interpreter;
}

void Shared::atCycleEnd(Work fresh) {
  std::erase_if(works_, [](const Work& one) { return one->cancelled(); });
  if (works_.empty())
    worksLatest_ = plc->controller().now() + controller::Controller::kLongestCycle;
  works_.push_back(std::move(fresh));
  settle(plc->controller().now());
}

bool Shared::settle(Instant limit) {
  const Instant end = std::min(limit, worksLatest_);
  const bool ended = plc->controller().settle(end - plc->controller().now());
  if (!ended && end < worksLatest_) return false;
  for (const Work& one : std::exchange(works_, {})) one->carryOut();
  return true;
}

void Shared::dropWorks() {
  for (const Work& one : std::exchange(works_, {})) {
    one->cancel();
    one->carryOut();
  }
}

void Shared::remember(const std::string& opened) {
  constexpr std::size_t kMost = 20;
  std::erase(recent, opened);
  recent.insert(recent.begin(), opened);
  if (recent.size() > kMost) recent.pop_back();
}

void Shared::lookAtFiles() {
  if (!plc || lookTask_) return;
  if (const Work one = adding.lock(); one && !one->done()) return;
  constexpr std::uint64_t kNobody = 0;
  lookNumber_ = nextLook();
  look_ = std::make_shared<Listing>();
  lookTask_ = std::make_shared<Task>(
      kNobody, [to = look_, where = folder](const std::stop_token&) { *to = where.list(); });
  clerk(lookTask_);
}

void Shared::takeLook() {
  if (!lookTask_ || !lookTask_->done()) return;
  if (!lookTask_->failed()) take(lookNumber_, std::move(*look_));
  lookTask_ = nullptr;
}

void Shared::take(std::uint64_t look, Listing seen) {
  if (look < taken_) return;
  taken_ = look;
  if (files.take(std::move(seen))) ++filesRevision;
}

// One job does for all who ask meanwhile; one that came to nothing is begun again.
Job Shared::offlineJob(std::uint64_t owner) {
  if (offline_ && offline_->files == filesRevision) return nullptr;
  const bool lost = offlineJob_ && offlineJob_->task->done() && offlineJob_->task->failed();
  if (offlineJob_ && !lost && offlineJob_->result->files == filesRevision) return offlineJob_;
  offlineJob_ = makeCompileJob(owner, plc->build().project.path, {}, filesRevision);
  work(offlineJob_->task);
  return offlineJob_;
}

void Shared::take(const Job& job) {
  const bool newer = !offline_ || offline_->files < job->result->files;
  if (newer) discard(std::exchange(offline_, job->result));
  if (offlineJob_ == job) offlineJob_ = nullptr;
}

void Shared::giveUp(const Work& task) {
  task->cancel();
  if (offlineJob_ && offlineJob_->task == task) offlineJob_ = nullptr;
}

WatchExtent watched(const Browser& browser) {
  WatchExtent sum;
  for (const auto& [number, list] : browser.lists) sum += list.extent();
  return sum;
}

std::size_t pointItems(const Browser& browser, std::int64_t exceptWatch,
                       std::int64_t exceptModify) {
  std::size_t count = 0;
  for (const auto& [number, list] : browser.lists)
    if (number != exceptWatch) count += list.atPoint();
  for (const auto& [number, list] : browser.modifies)
    if (number != exceptModify) count += list.size();
  return count;
}

void Shared::loaded(BuildRef build, source::SymbolTable symbols) {
  discard(plc->buildRef());
  plc->replace(std::move(build), symbols);
  discard(std::make_shared<const source::SymbolTable>(std::move(symbols)));
  ++programRevision;
  probesWait = true;
}

void Shared::lookAtProgram() {
  ProgramRef now = plc ? plc->program() : nullptr;
  const bool changed = now != seenProgram_;
  if (changed && seenRevision_ == programRevision) {
    ++programRevision;
    probesWait = true;
  }
  seenRevision_ = programRevision;
  if (changed) discard(std::exchange(seenProgram_, std::move(now)));
}

void Shared::discard(std::shared_ptr<const void> what) {
  constexpr std::uint64_t kNobody = 0;
  if (what) clerk(std::make_shared<Task>(kNobody, [what = std::move(what)](const auto&) {}));
}

namespace {

void addStatus(Plc& plc, const monitor::StatusWish& wish) {
  monitor::Monitor& monitor = plc.monitor();
  const compilation::Build& build = plc.build();
  const auto code = monitor.program().find(wish.block);
  if (!code || monitor.debugger().status(wish.block, wish.environment) != nullptr) return;
  std::vector<monitor::CallValues> calls;
  if (build.program != nullptr && build.library != nullptr)
    calls = monitor::callsOf(*code, *build.program, *build.library, monitor.resolver());
  monitor.debugger().addStatus(wish.block, wish.environment, std::move(calls));
}

}  // namespace

// In STOP the status of the run that ended is all there will be: who comes back to it finds it.
bool Shared::isWanted(const monitor::ProgramStatus& status) const {
  if (std::ranges::any_of(wantedStatus,
                          [&](const auto& one) { return one.second == status.wish(); }))
    return true;
  return statusRests_ && status.calls() > 0;
}

void Shared::placeProbes() {
  if (!plc) return;
  const bool stopped = plc->controller().mode() == controller::Mode::Stop;
  if (statusRests_ && !stopped) probesWait = true;  // what nobody looks at costs nothing again
  if (!probesWait) return;
  if (plc->monitor().downloadWaits())
    return placed_.keep(plc->monitor().debugger(), folder, breakpoints);
  probesWait = false;
  monitor::Debugger& debugger = plc->monitor().debugger();
  const bool same = placedProgram_ == programRevision;
  statusRests_ = stopped;
  // While time stands, what was recorded is all there is.
  debugger.keepStatus([&](const auto& one) { return same && isWanted(one); });
  for (const auto& [browser, wish] : wantedStatus) addStatus(*plc, wish);
  if (same && placed_.are(breakpoints)) return;
  placed_.place(plc->monitor(), folder, breakpoints);
  placedProgram_ = programRevision;
}

}  // namespace merker::workbench
