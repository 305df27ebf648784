#include "workbench/workbench.h"

#include <algorithm>
#include <array>

#include "scenario/steps/serial.h"
#include "workbench/axis_shown.h"
#include "workbench/method.h"
#include "workbench/process_rows.h"
#include "workbench/station_rows.h"

namespace merker::workbench {

std::span<const std::span<const Method>> methodGroups() {
  static const std::array kGroups = {
      plcMethods(),       variableMethods(), fileMethods(),     programMethods(),
      dataMethods(),      debugMethods(),    symbolMethods(),   hardwareMethods(),
      diagnosisMethods(), processMethods(),  projectMethods(),  trendMethods(),
      modifyMethods(),    timerMethods(),    snapshotMethods(), recordingMethods(),
      downloadMethods(),  importMethods(),   serialMethods(),   networkMethods(),
      stationMethods(),   plcsMethods()};
  return kGroups;
}

const Method* findMethod(std::string_view name) {
  for (const auto group : methodGroups()) {
    const auto found = std::ranges::find(group, name, &Method::name);
    if (found != group.end()) return &*found;
  }
  return nullptr;
}

Answer empty() { return Json(Json::object()); }
Problems withoutPlace(const Problems& problems) {
  Problems list;
  for (Problem problem : problems.list()) {
    problem.position = nowhere();
    list.add(std::move(problem));
  }
  return list;
}
Answer done(const std::optional<Problem>& problem) {
  return problem ? Answer(one(*problem)) : empty();
}

Workbench::Workbench() {
  shared_.onCycle = [this] { sampleTrends(); };
  shared_.onPoint = [this](monitor::CyclePoint point) { reached(point); };
}

// The way back to the project of the command line is a click.
void Workbench::use(Workspace workspace) {
  shared_.workspace = std::move(workspace);
  if (!shared_.workspace.given().empty()) shared_.remember(shared_.workspace.given());
}

// Modify before sampling, so that watch lists see the values in the same cycle.
void Workbench::reached(monitor::CyclePoint point) {
  for (auto& [id, browser] : browsers_)
    for (auto& [number, list] : browser.modifies) list.reached(shared_.plc->monitor(), point);
  for (auto& [id, browser] : browsers_)
    for (auto& [number, list] : browser.lists) list.reached(*shared_.plc, point);
}

void Workbench::sampleTrends() {
  for (auto& [id, browser] : browsers_)
    for (auto& [number, trend] : browser.trends) trend.sample(*shared_.plc);
}

std::string Workbench::folder() const {
  if (shared_.lab) return shared_.lab->path;
  return shared_.plc ? shared_.plc->build().project.path : "";
}

void Workbench::show(std::shared_ptr<Laboratory> lab) {
  Listing seen = folderOf(lab->plcs[0]->build().project).list();
  shared_.show(std::move(lab), 0, false, std::move(seen));
}

void Workbench::show(std::shared_ptr<Plc> plc, bool example) {
  for (auto& [id, browser] : browsers_) browser.heldBits = {};
  Listing seen = plc ? folderOf(plc->build().project).list() : Listing();
  shared_.show(std::move(plc), example, std::move(seen));
}

void Workbench::closed(BrowserId browser) {
  dropWaiting(browser);
  releaseHeld(shared_, browsers_[browser]);
  if (shared_.plc) browsers_[browser].heldBits.release(shared_.plc->monitor());
  shared_.discard(std::move(browsers_[browser].download));
  shared_.discard(std::move(browsers_[browser].upload));
  browsers_.erase(browser);
  shared_.wantedStatus.erase(browser);
  shared_.probesWait = true;
}

void Workbench::beginFrame(std::int64_t nowMs) {
  nowMs_ = nowMs;
  constexpr std::int64_t kBetweenLooks = 1000;
  if (nowMs >= nextLook_) nextLook_ = nowMs + kBetweenLooks, shared_.lookAtFiles();
  shared_.takeLook();
  shared_.lookAtProgram();
  shared_.placeProbes();
  shared_.browsers = browsers_.size();
  state_ = state(shared_);
  readProcess();
  readSerial();
  readStations();
}

std::vector<std::string> Workbench::events(BrowserId id, const Enough& enough) {
  std::vector<std::string> texts;
  Browser& browser = browsers_[id];
  Json changed = difference(browser.state, state_);
  if (!changed.empty()) {
    browser.state = state_;
    changed["event"] = "state";
    texts.push_back(dump(changed));
  }
  if (!shared_.plc) return texts;
  if (browser.status) {
    Json rows = browser.status->changes(shared_.plc->monitor(), shared_.folder, nowMs_);
    if (!rows.is_null()) texts.push_back(dump(rows));
  }
  addLists(browser, texts, enough);
  addProcess(browser, texts);
  addSerial(browser, texts);
  addStations(browser, texts);
  return texts;
}

namespace {

// One after the other, beginning behind the one that came last; a list of which there is no time
// for comes first the next time.
template <typename Lists>
void inTurn(Lists& lists, std::int64_t& last, const Workbench::Enough& enough, auto&& tell) {
  auto next = lists.upper_bound(last);
  for (std::size_t count = 0; count < lists.size() && (count == 0 || !enough()); ++count, ++next) {
    if (next == lists.end()) next = lists.begin();
    last = next->first;
    tell(next->first, next->second);
  }
}

}  // namespace

void Workbench::addLists(Browser& browser, std::vector<std::string>& texts, const Enough& enough) {
  inTurn(browser.lists, browser.lastList, enough, [&](std::int64_t number, WatchList& list) {
    Json values = list.changes(*shared_.plc, shared_.programRevision, nowMs_);
    if (values.empty()) return;
    Json event = {{"event", "values"},
                  {"list", number},
                  {"time", shared_.plc->controller().now().ns},
                  {"values", std::move(values)}};
    if (list.done()) event["done"] = true;
    texts.push_back(dump(event));
  });
  for (auto& [number, list] : browser.modifies)
    if (list.takeDone()) texts.push_back(dump({{"event", "modified"}, {"list", number}}));
  inTurn(browser.trends, browser.lastTrend, enough, [&](std::int64_t number, Trend& trend) {
    const std::string rows = trend.takeRows(*shared_.plc, shared_.programRevision);
    if (!rows.empty())
      texts.push_back(fmt::format(R"({{"event":"samples","list":{},"rows":{}}})", number, rows));
  });
}

// The values are the same for all browsers: they are read once a frame.
void Workbench::readProcess() {
  const bool watched =
      std::ranges::any_of(browsers_, [](const auto& one) { return one.second.process; });
  if (!watched || !shared_.plc || !shared_.plc->can(monitor::Feature::Plants)) return;
  const plant::Plants* plants = std::as_const(*shared_.plc).plants();
  auto event = std::make_shared<Json>(
      Json{{"event", "process"},
           {"plants", plants == nullptr ? Json::object() : plantValues(*plants)},
           {"stuck", plants == nullptr ? Json::object() : plantFaults(*plants)},
           {"axis", axisShown(*shared_.plc)}});
  if (!process_ || *event != *process_) process_ = std::move(event);
}

void Workbench::addProcess(Browser& browser, std::vector<std::string>& texts) {
  if (!browser.process || process_ == nullptr || browser.processValues == process_) return;
  browser.processValues = process_;
  Json event = *process_;
  event["time"] = shared_.plc->controller().now().ns;
  texts.push_back(dump(event));
}

// A few times a second, for all browsers: a busy line costs the PLC little.
void Workbench::readSerial() {
  constexpr std::int64_t kBetweenLooks = 200;
  const bool watched =
      std::ranges::any_of(browsers_, [](const auto& one) { return one.second.serial.on; });
  if (!watched || !shared_.plc || nowMs_ < nextSerial_) return;
  nextSerial_ = nowMs_ + kBetweenLooks;
  serialLine_ = nullptr;
  auto* const coupling = simulator::steps::couplingOf(shared_.plc->controller());
  if (coupling == nullptr) return;
  shared_.serialView.look(*coupling);
  serialLine_ = serialLine(*coupling, shared_.serialOutside());
}

void Workbench::addSerial(Browser& browser, std::vector<std::string>& texts) {
  Browser::Serial& seen = browser.serial;
  if (!seen.on || serialLine_.is_null()) return;
  if (seen.shown != shared_.shown) seen = {.on = true, .shown = shared_.shown};
  const std::uint64_t end = shared_.serialView.end();
  if (seen.told == end && seen.line == serialLine_) return;
  Json rows = shared_.serialView.rows(seen.told);
  seen.line = serialLine_;
  texts.push_back(dump({{"event", "serial"},
                        {"first", seen.told - rows.size()},
                        {"rows", std::move(rows)},
                        {"line", serialLine_}}));
}

// Ten times a second, for all browsers.
void Workbench::readStations() {
  constexpr std::int64_t kBetweenLooks = 100;
  const bool watched =
      std::ranges::any_of(browsers_, [](const auto& one) { return one.second.stations; });
  if (!watched || !shared_.lab || nowMs_ < nextStations_) return;
  nextStations_ = nowMs_ + kBetweenLooks;
  stations_ = stationsNow(*shared_.lab);
}

void Workbench::addStations(Browser& browser, std::vector<std::string>& texts) {
  if (!browser.stations || !shared_.lab || stations_.is_null()) return;
  if (browser.stationsSeen == stations_) return;
  browser.stationsSeen = stations_;
  texts.push_back(dump(stations_));
}

// A single step that takes long: part by part, whatever the pace is.
void Workbench::stepOn(const Enough& enough) {
  constexpr Duration kStepPart = Duration::milliseconds(10);
  monitor::Debugger& debugger = shared_.plc->monitor().debugger();
  const Instant end = *shared_.stepEnds;
  const auto now = [&] { return shared_.plc->controller().now(); };
  while (debugger.stepping() && now() < end && !enough())
    debugger.stepOn(std::min(now() + kStepPart, end));
  if (debugger.stepping() && now() < end) return;
  if (debugger.stepping()) debugger.giveUpStep();
  shared_.stepEnds.reset();
  shared_.plc->controller().advanceTo(now());  // other stations come along
  shared_.pacer.rebase();
}

// Somebody looks at the CPU between two cycles: a long one goes on part by part.
void Workbench::settleOn(const Enough& enough) {
  constexpr Duration kSettlePart = Duration::milliseconds(10);
  while (!enough() && !shared_.settle(shared_.plc->controller().now() + kSettlePart)) {
  }
}

bool Workbench::advance(const Pacer::WallClock& wall, Duration longest) {
  if (!shared_.plc) return false;
  enter("the PLC");
  const std::int64_t end = wall() + longest.ns;
  const Enough enough = [&] { return wall() >= end; };
  if (shared_.stepEnds) return stepOn(enough), true;
  if (shared_.settles()) return settleOn(enough), true;
  const Schedule schedule{[this] { return nextAction(); }, [&] { play(enough); }};
  return shared_.pacer.advance(shared_.plc->controller(), wall, longest, schedule);
}

}  // namespace merker::workbench
