// From the text of a request to the text of its answer: at once, after a compilation, or from a
// recording.
#include <algorithm>

#include "workbench/message.h"
#include "workbench/method.h"
#include "workbench/workbench.h"

namespace merker::workbench {
namespace {

constexpr std::size_t kMostWaiting = 64;  // of each browser

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

Answer compiled(const Call& call, const std::string& project,
                std::map<std::string, std::string> unsaved,
                std::function<Answer(const Call&, Offline&)> then) {
  auto job = std::make_shared<CompileJob>(project, std::move(unsaved), call.shared.filesRevision);
  call.shared.work([job] { job->run(); });
  return Answer::later(std::make_shared<Later>(Later{job, std::move(then)}));
}

namespace {

// When the program on the disk is compiled.
Answer afterCompilation(const Method& method, const Job& job) {
  return Answer::later(
      std::make_shared<Later>(Later{job, [&method, job](const Call& call, Offline&) {
                                      call.shared.take(job);
                                      return method.run(call);
                                    }}));
}

Answer begin(const Method& method, const Call& call) {
  const Job job = method.kind == Kind::Compiled ? call.shared.offlineJob() : nullptr;
  return job ? afterCompilation(method, job) : method.run(call);
}

}  // namespace

void Workbench::compileBy(Worker worker) { shared_.work = std::move(worker); }

Answer Workbench::run(BrowserId id, const Json& request) {
  Problems problems;
  const Fields fields(request, problems);
  const std::string name = fields.text("do");
  if (!fields.good()) return problems;
  const Method* method = findMethod(name);
  if (method == nullptr) return refused(ProblemCode::P1304, name.substr(0, 100));
  if (auto why = missing(method->needs, shared_.plc.get(), name)) return *why;
  const Instant now = shared_.plc ? shared_.plc->controller().now() : Instant{};
  Answer answer = begin(*method, {shared_, id, browsers_[id], fields});
  if (answer && method->kind == Kind::Action) shared_.recorder.note(request, now);
  return answer;
}

std::string Workbench::answerText(std::int64_t id, Answer answer) {
  if (answer) return dump({{"id", id}, {"result", std::move(answer.json())}});
  for (Json& problem : answer.json()) relate(problem, shared_.folder);
  return dump({{"id", id}, {"problems", std::move(answer.json())}});
}

std::string Workbench::handle(BrowserId browser, std::string_view message) {
  auto request = parseMessage(message);
  if (!request) return dump({{"id", 0}, {"problems", toJson(one(request.error()))}});
  const std::int64_t id = requestId(*request);
  if (id == 0) return dump({{"id", 0}, {"problems", toJson(refused(ProblemCode::P1303))}});
  const auto mine = [&](const Waiting& one) { return one.browser == browser; };
  if (std::ranges::count_if(waiting_, mine) >= static_cast<std::ptrdiff_t>(kMostWaiting))
    return answerText(id, refused(ProblemCode::P1314, kMostWaiting, "requests that compile"));
  Answer answer = run(browser, *request);
  if (!answer.waits()) return answerText(id, std::move(answer));
  const Method* method = findMethod((*request)["do"].get_ref<const std::string&>());
  Waiting waiting{browser, std::move(*request), method, shared_.shown, answer.waits()};
  if (waiting.later->job->done()) return settle(std::move(waiting));
  waiting_.push_back(std::move(waiting));
  return {};
}

// What it needs may have gone meanwhile.
std::string Workbench::settle(Waiting waiting) {
  const std::int64_t id = requestId(waiting.request);
  const Method& method = *waiting.method;
  if (auto why = missing(method.needs, shared_.plc.get(), method.name)) return answerText(id, *why);
  if (method.needs != Needs::Nothing && waiting.shown != shared_.shown)
    return answerText(
        id, refused(ProblemCode::P1308, method.name, "another project was opened meanwhile"));
  Problems problems;
  const Fields fields(waiting.request, problems);
  const Call call{shared_, waiting.browser, browsers_[waiting.browser], fields};
  return answerText(id, waiting.later->then(call, waiting.later->job->result()));
}

std::vector<std::pair<Workbench::BrowserId, std::string>> Workbench::laterAnswers() {
  std::vector<std::pair<BrowserId, std::string>> answers;
  std::vector<Waiting> ready;
  for (std::size_t i = 0; i < waiting_.size();) {
    if (!waiting_[i].later->job->done()) {
      ++i;
      continue;
    }
    ready.push_back(std::move(waiting_[i]));
    waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(i));
  }
  for (Waiting& one : ready) {
    const BrowserId browser = one.browser;
    if (browsers_.contains(browser)) answers.emplace_back(browser, settle(std::move(one)));
  }
  return answers;
}

// All that is due now, as if a browser had asked for it.
void Workbench::play() {
  constexpr BrowserId kNobody = 0;
  Player& player = shared_.player;
  while (player.next() <= shared_.plc->controller().now()) {
    const Json request = player.take();
    Problems problems;
    const Fields fields(request, problems);
    const Method* method = findMethod(fields.text("do"));
    Browser nobody;
    auto why = missing(method->needs, shared_.plc.get(), method->name);
    const Answer answer = why ? Answer(*why) : method->run({shared_, kNobody, nobody, fields});
    if (!answer) player.fail(answer.json()[0]);
  }
}

}  // namespace merker::workbench
