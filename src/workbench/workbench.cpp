#include "workbench/workbench.h"

#include <algorithm>

#include "workbench/message.h"
#include "workbench/method.h"

namespace merker::workbench {
namespace {

const Method* findMethod(std::string_view name) {
  for (const auto group : {plcMethods(), variableMethods()}) {
    const auto found = std::ranges::find(group, name, &Method::name);
    if (found != group.end()) return &*found;
  }
  return nullptr;
}

std::optional<Problems> missing(Needs needs, const Plc* plc, std::string_view method) {
  if (needs == Needs::Nothing) return std::nullopt;
  if (plc == nullptr) return refused(ProblemCode::P1315);
  if (needs == Needs::Plc || plc->isS7()) return std::nullopt;
  return refused(ProblemCode::P1307, plc->controller().modelName(), method);
}

}  // namespace

Answer empty() { return Json(Json::object()); }
Answer done(const std::optional<Problem>& problem) {
  return problem ? Answer(one(*problem)) : empty();
}

void Workbench::show(std::unique_ptr<Plc> plc, bool example) {
  shared_.plc = std::move(plc);
  shared_.example = example;
  shared_.pacer.restart();
  ++shared_.programRevision;
  ++shared_.filesRevision;
}

Answer Workbench::run(Browser& browser, const Json& request) {
  Problems problems;
  const Fields fields(request, problems);
  const std::string name = fields.text("do");
  if (!fields.good()) return problems;
  const Method* method = findMethod(name);
  if (method == nullptr) return refused(ProblemCode::P1304, name.substr(0, 100));
  if (auto why = missing(method->needs, shared_.plc.get(), name)) return *why;
  return method->run({shared_, browser, fields});
}

std::string Workbench::handle(BrowserId browser, std::string_view message) {
  const auto request = parseMessage(message);
  if (!request) return dump({{"id", 0}, {"problems", toJson(one(request.error()))}});
  const std::int64_t id = requestId(*request);
  if (id == 0) return dump({{"id", 0}, {"problems", toJson(refused(ProblemCode::P1303))}});
  const Answer answer = run(browsers_[browser], *request);
  if (answer) return dump({{"id", id}, {"result", *answer}});
  const std::string folder = shared_.plc ? shared_.plc->build().project.folder : std::string();
  return dump({{"id", id}, {"problems", toJson(answer.error(), folder)}});
}

void Workbench::beginFrame(std::int64_t nowMs) {
  nowMs_ = nowMs;
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
  for (auto& [number, list] : browser.lists) {
    Json values = list.changes(*shared_.plc, shared_.programRevision, nowMs_);
    if (values.empty()) continue;
    texts.push_back(dump({{"event", "values"},
                          {"list", number},
                          {"time", shared_.plc->controller().now().ns},
                          {"values", std::move(values)}}));
  }
  return texts;
}

bool Workbench::advance(const Pacer::WallClock& wall, Duration longest) {
  return shared_.plc && shared_.pacer.advance(shared_.plc->controller(), wall, longest);
}

}  // namespace merker::workbench
