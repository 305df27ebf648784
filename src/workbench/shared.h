// What all browsers share, and what each has of its own.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "workbench/compile_job.h"
#include "workbench/file_watch.h"
#include "workbench/modify_list.h"
#include "workbench/pace.h"
#include "workbench/plc.h"
#include "workbench/project_folder.h"
#include "workbench/recording.h"
#include "workbench/status_view.h"
#include "workbench/trend.h"
#include "workbench/watch_list.h"
#include "workbench/workspace.h"

namespace merker::workbench {

constexpr std::size_t kLists = 64, kItems = 1000;  // of each browser, of each list

// Lines with breakpoints by file, relative to the project folder.
using BreakpointLines = std::map<std::string, std::set<std::uint32_t>>;

struct Shared {
  std::unique_ptr<Plc> plc;  // null: no project is open
  bool example = false;      // it is a copy of one
  Pacer pacer;
  std::uint64_t programRevision = 1, filesRevision = 1;
  Workspace workspace;
  std::vector<std::string> recent;  // folders, newest first
  std::function<void()> onCycle;    // at each end of a cycle, of whatever PLC is there
  std::function<void(cpu::CyclePoint)> onPoint;
  Worker work = [](const Work& one) { one(); };
  std::uint64_t shown = 0;  // counts the PLCs
  Recorder recorder;
  Player player;
  ProjectFolder folder;
  FileWatch files;
  BreakpointLines breakpoints;
  std::map<std::uint64_t, BlockId> wantedStatus;  // by browser
  bool probesWait = false;  // breakpoints and program status are not those that are wanted

  void show(std::unique_ptr<Plc> fresh, bool isExample);
  void remember(const std::string& opened);
  void lookAtFiles();
  // Null: the program on the disk is compiled.
  Job offlineJob();
  void take(const Job& job);  // that is done
  // As it was compiled last.
  const Offline& offline() const { return *offline_; }
  // The CPU has this program now, or will have it at its next checkpoint.
  void loaded(compilation::Build build);
  // As soon as the CPU works with the program that it was given last.
  void placeProbes();

 private:
  std::optional<Offline> offline_;
  std::optional<station::Engine> engine_;  // that was chosen last: the next PLC has it too
  Job offlineJob_;
};

struct Browser {
  Json state = Json::object();  // what it knows of it
  std::map<std::int64_t, WatchList> lists;
  std::map<std::int64_t, Trend> trends;
  std::map<std::int64_t, ModifyList> modifies;
  std::optional<StatusView> status;
  bool process = false;
  Json processValues;                                  // as told last
  std::set<std::pair<std::string, std::string>> held;  // plant and signal: pressed until let go
};

// All of the event "state".
Json state(Shared& shared);
// What differs; null stands for a field that is now null.
Json difference(const Json& before, const Json& now);

}  // namespace merker::workbench
