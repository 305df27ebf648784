#include "workbench/workbench.h"

#include <algorithm>

#include "workbench/method.h"
#include "workbench/process_rows.h"

namespace merker::workbench {

const Method* findMethod(std::string_view name) {
  for (const auto group :
       {plcMethods(), variableMethods(), fileMethods(), programMethods(), debugMethods(),
        symbolMethods(), hardwareMethods(), diagnosisMethods(), processMethods(), projectMethods(),
        trendMethods(), modifyMethods(), timerMethods(), snapshotMethods(), recordingMethods()}) {
    const auto found = std::ranges::find(group, name, &Method::name);
    if (found != group.end()) return &*found;
  }
  return nullptr;
}

Answer empty() { return Json(Json::object()); }
Answer done(const std::optional<Problem>& problem) {
  return problem ? Answer(one(*problem)) : empty();
}

Workbench::Workbench() {
  shared_.onCycle = [this] { sampleTrends(); };
  shared_.onPoint = [this](cpu::CyclePoint point) { reached(point); };
}

// What is modified at this point is seen at it.
void Workbench::reached(cpu::CyclePoint point) {
  for (auto& [id, browser] : browsers_)
    for (auto& [number, list] : browser.modifies) list.reached(*shared_.plc->monitor(), point);
  for (auto& [id, browser] : browsers_)
    for (auto& [number, list] : browser.lists) list.reached(*shared_.plc, point);
}

void Workbench::sampleTrends() {
  for (auto& [id, browser] : browsers_)
    for (auto& [number, trend] : browser.trends) trend.sample(*shared_.plc);
}

void Workbench::show(std::unique_ptr<Plc> plc, bool example) {
  shared_.show(std::move(plc), example);
}

void Workbench::closed(BrowserId browser) {
  releaseHeld(shared_, browsers_[browser]);
  browsers_.erase(browser);
  shared_.wantedStatus.erase(browser);
  shared_.probesWait = true;
}

void Workbench::beginFrame(std::int64_t nowMs) {
  nowMs_ = nowMs;
  constexpr std::int64_t kBetweenLooks = 1000;
  if (nowMs >= nextLook_) nextLook_ = nowMs + kBetweenLooks, shared_.lookAtFiles();
  shared_.placeProbes();
  state_ = state(shared_);
}

std::vector<std::string> Workbench::events(BrowserId id) {
  std::vector<std::string> texts;
  Browser& browser = browsers_[id];
  Json changed = difference(browser.state, state_);
  if (!changed.empty()) {
    browser.state = state_;
    changed["event"] = "state";
    texts.push_back(dump(changed));
  }
  if (!shared_.plc) return texts;
  if (browser.status && shared_.plc->isS7()) {
    Json rows = browser.status->changes(*shared_.plc->monitor(), shared_.folder, nowMs_);
    if (!rows.is_null()) texts.push_back(dump(rows));
  }
  addLists(browser, texts);
  addProcess(browser, texts);
  return texts;
}

void Workbench::addLists(Browser& browser, std::vector<std::string>& texts) {
  for (auto& [number, list] : browser.lists) {
    Json values = list.changes(*shared_.plc, shared_.programRevision, nowMs_);
    if (values.empty()) continue;
    Json event = {{"event", "values"},
                  {"list", number},
                  {"time", shared_.plc->controller().now().ns},
                  {"values", std::move(values)}};
    if (list.done()) event["done"] = true;
    texts.push_back(dump(event));
  }
  for (auto& [number, list] : browser.modifies)
    if (list.takeDone()) texts.push_back(dump({{"event", "modified"}, {"list", number}}));
  for (auto& [number, trend] : browser.trends) {
    Json rows = trend.takeRows(*shared_.plc, shared_.programRevision);
    if (!rows.empty())
      texts.push_back(dump({{"event", "samples"}, {"list", number}, {"rows", std::move(rows)}}));
  }
}

void Workbench::addProcess(Browser& browser, std::vector<std::string>& texts) {
  if (!browser.process || !shared_.plc->isS7()) return;
  const plant::Plants* plants = shared_.plc->station()->plants();
  Json event = {{"event", "process"},
                {"plants", plants == nullptr ? Json::object() : plantValues(*plants)},
                {"stuck", plants == nullptr ? Json::object() : plantFaults(*plants)}};
  if (event == browser.processValues) return;
  browser.processValues = event;
  event["time"] = shared_.plc->controller().now().ns;
  texts.push_back(dump(event));
}

bool Workbench::advance(const Pacer::WallClock& wall, Duration longest) {
  if (!shared_.plc) return false;
  const Schedule schedule{[this] { return shared_.player.next(); }, [this] { play(); }};
  return shared_.pacer.advance(shared_.plc->controller(), wall, longest, schedule);
}

}  // namespace merker::workbench
