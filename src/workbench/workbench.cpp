#include "workbench/workbench.h"

#include <algorithm>

#include "workbench/message.h"
#include "workbench/method.h"
#include "workbench/process_rows.h"

namespace merker::workbench {
namespace {

const Method* findMethod(std::string_view name) {
  for (const auto group : {plcMethods(), variableMethods(), fileMethods(), programMethods(),
                           debugMethods(), symbolMethods(), hardwareMethods(), diagnosisMethods(),
                           processMethods(), projectMethods(), trendMethods()}) {
    const auto found = std::ranges::find(group, name, &Method::name);
    if (found != group.end()) return &*found;
  }
  return nullptr;
}

std::optional<Problems> missing(Needs needs, const Plc* plc, std::string_view method) {
  if (needs == Needs::Nothing) return std::nullopt;
  if (plc == nullptr) return refused(ProblemCode::P1315);
  const bool on = needs == Needs::PlcOn || needs == Needs::S7On;
  if (on && !plc->controller().powered())
    return refused(ProblemCode::P1308, plc->controller().modelName(), "it is switched off");
  if (needs == Needs::Plc || needs == Needs::PlcOn || plc->isS7()) return std::nullopt;
  return refused(ProblemCode::P1307, plc->controller().modelName(), method);
}

}  // namespace

Answer empty() { return Json(Json::object()); }
Answer done(const std::optional<Problem>& problem) {
  return problem ? Answer(one(*problem)) : empty();
}

Workbench::Workbench() {
  shared_.onCycle = [this] { sampleTrends(); };
}

void Workbench::sampleTrends() {
  for (auto& [id, browser] : browsers_)
    for (auto& [number, trend] : browser.trends) trend.sample(*shared_.plc);
}

void Workbench::show(std::unique_ptr<Plc> plc, bool example) {
  shared_.show(std::move(plc), example);
}

void Workbench::closed(BrowserId browser) {
  browsers_.erase(browser);
  shared_.wantedStatus.erase(browser);
  shared_.probesWait = true;
}

Answer Workbench::run(BrowserId id, const Json& request) {
  Browser& browser = browsers_[id];
  Problems problems;
  const Fields fields(request, problems);
  const std::string name = fields.text("do");
  if (!fields.good()) return problems;
  const Method* method = findMethod(name);
  if (method == nullptr) return refused(ProblemCode::P1304, name.substr(0, 100));
  if (auto why = missing(method->needs, shared_.plc.get(), name)) return *why;
  return method->run({shared_, id, browser, fields});
}

std::string Workbench::handle(BrowserId browser, std::string_view message) {
  const auto request = parseMessage(message);
  if (!request) return dump({{"id", 0}, {"problems", toJson(one(request.error()))}});
  const std::int64_t id = requestId(*request);
  if (id == 0) return dump({{"id", 0}, {"problems", toJson(refused(ProblemCode::P1303))}});
  Answer answer = run(browser, *request);
  if (answer) return dump({{"id", id}, {"result", std::move(answer.json())}});
  for (Json& problem : answer.json()) relate(problem, shared_.folder);
  return dump({{"id", id}, {"problems", std::move(answer.json())}});
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
    texts.push_back(dump({{"event", "values"},
                          {"list", number},
                          {"time", shared_.plc->controller().now().ns},
                          {"values", std::move(values)}}));
  }
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
  return shared_.plc && shared_.pacer.advance(shared_.plc->controller(), wall, longest);
}

}  // namespace merker::workbench
