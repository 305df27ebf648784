// From the text of a request to the text of its answer: at once, after a compilation, or from a
// recording.
#include <algorithm>

#include "base/text.h"
#include "workbench/elsewhere.h"
#include "workbench/workbench.h"

namespace merker::workbench {
namespace {

// Of each browser; beyond these bytes its next request waits until some are answered.
constexpr std::size_t kMostWaiting = 64, kMostWaitingBytes = 4 << 20;

std::optional<Problems> missing(Needs needs, const Plc* plc) {
  if (needs.state == Needs::State::Nothing) return std::nullopt;
  if (plc == nullptr) return refused(ProblemCode::P1315);
  if (needs.state == Needs::State::PlcOn && !plc->controller().powered())
    return refused(ProblemCode::P1308, plc->controller().modelName(), "it is switched off");
  if (!needs.feature || plc->can(*needs.feature)) return std::nullopt;
  return refused(ProblemCode::P1307, plc->controller().modelName(), monitor::what(*needs.feature));
}

// A request may say which station it is meant for: another browser may show another one by now.
std::optional<Problems> ofAnother(std::string_view method, const Fields& fields,
                                  const Shared& shared) {
  if (method.starts_with("stations.") || !shared.lab || !fields.has("station")) return std::nullopt;
  const std::string wanted = fields.text("station"), shown = shared.stationName();
  if (!fields.good()) return fields.problems();
  if (equalsIgnoreCase(wanted, shown)) return std::nullopt;
  return refused(ProblemCode::P1308, wanted, "another station is shown now: " + shown);
}

// When the program on the disk is compiled.
Answer afterCompilation(const Method& method, const Job& job) {
  return later(job->task, [&method, job](const Call& call) {
    call.shared.take(job);
    return method.run(call);
  });
}

// First the folder is looked at: what was compiled last may still do.
Answer afterLook(const Method& method, const Call& call) {
  const std::uint64_t number = call.shared.nextLook();
  return elsewhere<Listing>(
      call, call.shared.clerk, [](const Aside& aside) { return aside.folder.list(); },
      [&method, number](const Call& now, Listing& seen) {
        now.shared.take(number, std::move(seen));
        const Job job = now.shared.offlineJob(now.id);
        return job ? afterCompilation(method, job) : method.run(now);
      });
}

Answer begin(const Method& method, const Call& call) {
  return method.kind == Kind::Compiled ? afterLook(method, call) : method.run(call);
}

// Requests behind it wait: answers come in the order of their requests.
bool holdsUp(const Waiting& one) {
  return one.method->kind != Kind::Compiled && one.method->kind != Kind::Compiles;
}

}  // namespace

void Workbench::compileBy(Worker worker) { shared_.work = std::move(worker); }
void Workbench::helpBy(Worker worker) { shared_.clerk = std::move(worker); }
void Workbench::importBy(Worker worker) { shared_.helper = std::move(worker); }

Answer Workbench::run(Waiting& waiting) {
  Problems problems;
  const Fields fields(*waiting.request.json, problems);
  const std::string name = fields.text("do");
  if (!fields.good()) return problems;
  waiting.method = findMethod(name);
  if (waiting.method == nullptr) return refused(ProblemCode::P1304, name.substr(0, 100));
  if (auto why = missing(waiting.method->needs, shared_.plc.get())) return *why;
  if (auto why = ofAnother(name, fields, shared_)) return *why;
  enter(waiting.method->name);
  return begin(*waiting.method, {shared_, waiting.browser, browsers_[waiting.browser], fields,
                                 waiting.request.json});
}

// What it needs may have gone meanwhile.
Answer Workbench::settle(const Waiting& waiting) {
  const Method& method = *waiting.method;
  if (waiting.outdated)
    return refused(ProblemCode::P1308, method.name, "a newer request of this browser replaced it");
  if (waiting.later->task->failed())
    return refused(ProblemCode::P1308, method.name, "it was cancelled");
  if (auto why = missing(method.needs, shared_.plc.get())) return *why;
  if (method.needs.state != Needs::State::Nothing && waiting.shown != shared_.shown)
    return refused(ProblemCode::P1308, method.name, "another project was opened in the meantime");
  enter(method.name);
  Problems problems;
  const Fields fields(*waiting.request.json, problems);
  return waiting.later->then(
      {shared_, waiting.browser, browsers_[waiting.browser], fields, waiting.request.json});
}

// Until it waits for something that is not done yet; empty then.
std::string Workbench::proceed(Waiting waiting, Answer answer, Instant now) {
  while (answer.waits()) {
    waiting.later = answer.waits();
    if (!waiting.later->task->done()) return park(std::move(waiting)), std::string();
    answer = settle(waiting);
  }
  const bool action = waiting.method != nullptr && waiting.method->kind == Kind::Action;
  if (answer && action) shared_.recorder.note(*waiting.request.json, now);
  if (waiting.request.bytes > kSmallMessage) shared_.discard(std::move(waiting.request.json));
  return answerText(waiting.id, std::move(answer));
}

// A check of texts that are typed makes older ones of the same browser useless.
void Workbench::park(Waiting waiting) {
  if (waiting.later->newest)
    for (Waiting& other : waiting_)
      if (other.browser == waiting.browser && other.later->newest && !other.outdated) {
        other.outdated = true;
        other.later->task->cancel();
      }
  waiting_.push_back(std::move(waiting));
}

std::string Workbench::answerText(std::int64_t id, Answer answer) {
  if (answer.text().empty()) answer = written(std::move(answer), shared_.folder);
  return fmt::format(R"({{"id":{},"{}":{}}})", id, answer ? "result" : "problems", answer.text());
}

std::string Workbench::handle(BrowserId browser, std::string_view message) {
  return handle(browser, readRequest(message));
}

std::string Workbench::handle(BrowserId browser, Request request) {
  if (!request.json)
    return answerText(0, one(request.wrong.value_or(makeProblem(ProblemCode::P1301, nowhere()))));
  const std::int64_t id = requestId(*request.json);
  if (id == 0) return answerText(0, refused(ProblemCode::P1303));
  const auto mine = [&](const Waiting& one) { return one.browser == browser; };
  if (std::ranges::count_if(waiting_, mine) >= static_cast<std::ptrdiff_t>(kMostWaiting))
    return answerText(id, refused(ProblemCode::P1314, kMostWaiting, "requests that compile"));
  const Instant now = shared_.plc ? shared_.plc->controller().now() : Instant{};
  Waiting waiting;
  waiting.browser = browser;
  waiting.id = id;
  waiting.request = std::move(request);
  waiting.shown = shared_.shown;
  Answer answer = run(waiting);
  return proceed(std::move(waiting), std::move(answer), now);
}

bool Workbench::busy(BrowserId browser) const {
  std::size_t bytes = 0;
  for (const Waiting& one : waiting_) {
    if (one.browser != browser) continue;
    if (holdsUp(one)) return true;
    bytes += one.request.bytes;
  }
  return bytes > kMostWaitingBytes;
}

std::vector<std::pair<Workbench::BrowserId, std::string>> Workbench::laterAnswers(
    const Enough& enough) {
  std::vector<std::pair<BrowserId, std::string>> answers;
  for (std::size_t left = waiting_.size(), i = 0; left > 0 && !enough(); --left) {
    const Waiting& next = waiting_[i];
    if (!next.outdated && !next.later->task->done()) {
      ++i;
      continue;
    }
    Waiting one = std::move(waiting_[i]);
    waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(i));
    const Instant now = shared_.plc ? shared_.plc->controller().now() : Instant{};
    const BrowserId browser = one.browser;
    Answer answer = settle(one);
    std::string text = proceed(std::move(one), std::move(answer), now);
    if (!text.empty()) answers.emplace_back(browser, std::move(text));
  }
  return answers;
}

// Nobody waits for its answers any more; what others wait for as well goes on.
void Workbench::dropWaiting(BrowserId browser) {
  std::vector<Work> dropped;
  std::erase_if(waiting_, [&](const Waiting& one) {
    if (one.browser == browser) dropped.push_back(one.later->task);
    return one.browser == browser;
  });
  for (const Work& task : dropped)
    if (std::ranges::none_of(waiting_, [&](const Waiting& one) { return one.later->task == task; }))
      shared_.giveUp(task);
}

// All that is due now, as if a browser had asked for it, as far as the slice lasts: virtual time
// waits for the rest, and for what is done elsewhere.
void Workbench::play(const Enough& enough) {
  Player& player = shared_.player;
  if (playing_) {
    if (!playing_->later->task->done()) return;
    Waiting one = std::move(*playing_);
    playing_.reset();
    Answer answer = settle(one);
    playOn(std::move(one), std::move(answer));
  }
  while (!playing_ && player.next() <= shared_.plc->controller().now() && !enough()) {
    constexpr BrowserId kNobody = 0;
    Waiting one;
    one.browser = kNobody;
    one.request.json = player.take();
    one.shown = shared_.shown;
    Answer answer = run(one);
    playOn(std::move(one), std::move(answer));
  }
  browsers_.erase(0);
}

void Workbench::playOn(Waiting one, Answer answer) {
  while (answer.waits()) {
    one.later = answer.waits();
    if (!one.later->task->done()) {
      playing_ = std::move(one);
      return;
    }
    answer = settle(one);
  }
  if (answer) return;
  if (answer.text().empty()) return shared_.player.fail(answer.json()[0]);
  shared_.player.fail(Json::parse(answer.text())[0]);
}

Instant Workbench::nextAction() const {
  return playing_ ? shared_.plc->controller().now() : shared_.player.next();
}

}  // namespace merker::workbench
