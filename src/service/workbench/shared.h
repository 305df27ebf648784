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

#include "archive/file.h"
#include "workbench/communication_view.h"
#include "workbench/compile_job.h"
#include "workbench/file_watch.h"
#include "workbench/held_bits.h"
#include "workbench/laboratory.h"
#include "workbench/modify_list.h"
#include "workbench/pace.h"
#include "workbench/page_breakpoints.h"
#include "workbench/plc.h"
#include "workbench/project_folder.h"
#include "workbench/recording.h"
#include "workbench/serial_view.h"
#include "workbench/status_view.h"
#include "workbench/trend.h"
#include "workbench/upload.h"
#include "workbench/watch_list.h"
#include "workbench/workspace.h"

namespace merker::workbench {

// Of one server, each with a project of its own.
constexpr std::size_t kPlcs = 4;
constexpr std::size_t kLists = 64, kItems = 1000;  // of each browser, of each list
// Of each browser, in all lists: they are read or written in every cycle.
constexpr std::size_t kPointItems = 2000;
// Of each browser, in all watch lists: 64 browsers hold some 200 MB.
constexpr std::size_t kWatched = 10'000, kWatchedBytes = 1'000'000;

class Neighbours;

struct Shared {
  std::shared_ptr<Plc> plc;         // null: no project is open
  std::shared_ptr<Laboratory> lab;  // null: it has one station only
  std::size_t station = 0;          // of these, the one that `plc` is
  bool example = false;             // it is a copy of one
  Pacer pacer;
  std::uint64_t programRevision = 1, filesRevision = 1;
  Workspace workspace;
  std::vector<std::string> recent;  // folders, newest first
  std::function<void()> onCycle;    // at each end of a cycle, of whatever PLC is there
  std::function<void(monitor::CyclePoint)> onPoint;
  // Who compiles, and who does what else takes longer than a slice.
  Worker work = [](const Work& one) { one->carryOut(); };
  Worker clerk = work;
  // Who packs and imports projects, which takes seconds.
  Worker helper = work;
  std::uint64_t shown = 0;  // counts the PLCs
  std::size_t browsers = 0;
  Neighbours* neighbours = nullptr;  // null: it is alone
  std::size_t plcNumber = 1;         // among them
  Recorder recorder;
  Player player;
  SerialView serialView;
  std::function<SerialOutside()> serialOutside = [] { return SerialOutside{}; };
  std::function<S7Outside()> s7Outside = [] { return S7Outside{}; };
  ProjectFolder folder;
  FileWatch files;
  BreakpointLines breakpoints;
  std::weak_ptr<Upload> upload;                               // of all browsers one
  std::uint64_t uploadOwner = 0;                              // the browser
  std::weak_ptr<Task> adding;                                 // that adds files to the project
  std::map<std::uint64_t, monitor::StatusWish> wantedStatus;  // by browser
  std::optional<Instant> stepEnds;                            // of the single step that goes on
  bool probesWait = false;  // breakpoints and program status are not those that are wanted

  // `seen`: what stands in its folder.
  void show(std::shared_ptr<Plc> fresh, bool isExample, Listing seen);
  // Of several stations this one.
  void show(std::shared_ptr<Laboratory> fresh, std::size_t shown, bool isExample, Listing seen);
  // Another one of them; all go on.
  void showStation(std::size_t number);
  // Empty: there is only one.
  std::string stationName() const { return lab ? lab->build.stations[station].name : ""; }
  void remember(const std::string& opened);
  // Looks at the folder, elsewhere; what is seen counts from `takeLook` on.
  void lookAtFiles();
  void takeLook();
  // Looks have numbers in the order in which they are taken: an older one counts no more.
  std::uint64_t nextLook() { return ++looks_; }
  void take(std::uint64_t look, Listing seen);
  // The engine that was chosen last, which the next PLC has, too.
  std::optional<station::Engine> engine() const;
  // Work in the PLC's thread, where the cycle has ended or the CPU has stopped: virtual time goes
  // on until then, part by part.
  void atCycleEnd(Work fresh);
  bool settles() const { return !works_.empty(); }
  // At most to `limit`; true: what waited for the end of the cycle is done.
  bool settle(Instant limit);
  // Null: the program on the disk is compiled. `owner`: the browser that asks for it.
  Job offlineJob(std::uint64_t owner);
  void take(const Job& job);  // that is done
  // Nobody waits for this any more.
  void giveUp(const Work& task);
  // As it was compiled last.
  const Offline& offline() const { return *offline_; }
  const OfflineRef& offlineRef() const { return offline_; }
  // The CPU has this program now, or will have it at its next checkpoint. `symbols`: a copy.
  void loaded(BuildRef build, source::SymbolTable symbols);
  // Where it is let go nobody waits: what is large takes its time to be freed.
  void discard(std::shared_ptr<const void> what);
  // Others load blocks, too (S7 communication).
  void lookAtProgram();
  // As soon as the CPU works with the program that it was given last.
  void placeProbes();

 private:
  OfflineRef offline_;
  void dropWorks();
  void leave();
  bool isWanted(const monitor::ProgramStatus& status) const;  // its status
  void exchange(std::shared_ptr<Plc> fresh);

  std::optional<station::Engine> engine_;  // of the PLC before
  std::vector<Work> works_;                // that wait for the end of the cycle
  Instant worksLatest_;
  Job offlineJob_;
  std::uint64_t looks_ = 0, taken_ = 0, lookNumber_ = 0;
  PageBreakpoints placed_;    // in the CPU, of this program
  bool statusRests_ = false;  // of the run that ended, in STOP
  std::uint64_t placedProgram_ = 0;
  ProgramRef seenProgram_;
  std::uint64_t seenRevision_ = 0;  // of `programRevision`
  std::shared_ptr<Listing> look_;   // that is on its way
  Work lookTask_;
};

// The files of the project: all of its folder, or those that were read of a program without one.
ProjectFolder folderOf(const project::Project& project);

struct Browser {
  Json state = Json::object();  // what it knows of it
  std::map<std::int64_t, WatchList> lists;
  std::map<std::int64_t, Trend> trends;
  std::map<std::int64_t, ModifyList> modifies;
  std::optional<StatusView> status;
  bool process = false;
  bool stations = false;                      // it wants the event of this name
  Json stationsSeen = nullptr;                // as told last
  std::shared_ptr<const Json> processValues;  // as told last
  struct Serial {
    bool on = false;
    std::uint64_t told = 0, shown = 0;  // characters; `shown` of Shared
    Json line{};                        // as told last
  } serial;
  std::shared_ptr<const archive::File> download;       // the project as a zip
  std::shared_ptr<Upload> upload;                      // that is to be imported
  Work importing;                                      // that looks at it
  std::int64_t lastList = -1, lastTrend = -1;          // told last
  std::set<std::pair<std::string, std::string>> held;  // plant and signal: pressed until let go
  HeldBits heldBits;
};

// All its watch lists.
WatchExtent watched(const Browser& browser);
// Operands that this browser has at trigger points, besides those of these lists.
std::size_t pointItems(const Browser& browser, std::int64_t exceptWatch, std::int64_t exceptModify);

// Of a CPU, or what stands for it: "RUN", and its LEDs.
std::string_view modeOf(const Plc& plc);
Json lampsOf(const Plc& plc);
// All of the event "state".
Json state(Shared& shared);
// What differs; null stands for a field that is now null.
Json difference(const Json& before, const Json& now);

}  // namespace merker::workbench
