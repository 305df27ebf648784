#include "desk.h"

#include <chrono>

namespace merker::app {
namespace {

// How long requests are handled, then virtual time runs, then browsers are told what is new; and
// how long nothing happens.
constexpr Duration kSlice = Duration::milliseconds(5);
constexpr Duration kShortPause = Duration::microseconds(250);
// 30 frames a second.
constexpr std::int64_t kFrame = 33'000'000;
// What may wait for its turn of a browser before nothing more is read from it; a message beyond
// these bytes is read all the same.
constexpr std::size_t kMostTexts = 64, kMostBytes = 1 << 20;
// Who has so much of its answers to read gets no further ones.
constexpr std::size_t kMostUnread = 1 << 20;

std::int64_t wallClock() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace

Desk::Desk(workbench::Workbenches& workbenches, Watchdog& watchdog)
    : workbenches_(workbenches), watchdog_(watchdog) {
  workbenches.each([this](workbench::Workbench& one) {
    one.compileBy([this](workbench::Work work) { compiler_.push(std::move(work)); });
    one.helpBy([this](workbench::Work work) { clerk_.push(std::move(work)); });
    one.importBy([this](workbench::Work work) { importer_.push(std::move(work)); });
    one.tellPlace([this](std::string_view place) { watchdog_.enter(place, current_); });
  });
}

void Desk::wake() {
  fresh_ = true;
  arrived_.notify_one();
}

void Desk::hurry() {
  const std::lock_guard lock(mutex_);
  wake();
}

void Desk::opened(hmi::BrowserId browser) {
  const std::lock_guard lock(mutex_);
  inboxes_[browser];
  comings_.emplace_back(browser, true);
  wake();
}

// What it has asked and nobody has begun is not done any more.
void Desk::closed(hmi::BrowserId browser) {
  const std::lock_guard lock(mutex_);
  if (const auto found = inboxes_.find(browser); found != inboxes_.end()) {
    if (found->second.reading) found->second.reading->task->cancel();
    inboxes_.erase(found);
  }
  comings_.emplace_back(browser, false);
  wake();
}

bool Desk::received(hmi::BrowserId browser, std::string text) {
  const std::lock_guard lock(mutex_);
  Inbox& inbox = inboxes_[browser];
  inbox.bytes += text.size();
  inbox.texts.push_back(std::move(text));
  inbox.paused = inbox.texts.size() >= kMostTexts || inbox.bytes > kMostBytes;
  wake();
  return !inbox.paused;
}

void Desk::wait() {
  watchdog_.leave();
  const Duration longest = waitedFor_() ? kShortPause : kSlice;
  std::unique_lock lock(mutex_);
  arrived_.wait_for(lock, std::chrono::nanoseconds(longest.ns), [this] { return fresh_; });
  fresh_ = false;
}

void Desk::greet() {
  std::deque<std::pair<hmi::BrowserId, bool>> comings;
  {
    const std::lock_guard lock(mutex_);
    comings.swap(comings_);
  }
  for (const auto& [browser, came] : comings) {
    watchdog_.enter(came ? "a new browser" : "a browser that has gone", browser);
    if (came) {
      browsers_.insert(browser);
      workbenches_.opened(browser);
    } else {
      browsers_.erase(browser);
      unframed_.erase(browser);
      workbenches_.closed(browser);
    }
  }
}

// A long message is read by the clerk first.
bool Desk::ready(hmi::BrowserId browser, Inbox& inbox) {
  if (inbox.texts.empty()) return false;
  if (inbox.reading) return inbox.reading->task->done();
  if (inbox.texts.front().size() <= workbench::kSmallMessage) return true;
  auto request = std::make_shared<workbench::Request>();
  const std::size_t bytes = inbox.texts.front().size();
  auto task = std::make_shared<workbench::Task>(
      browser,
      [request, text = std::make_shared<const std::string>(std::move(inbox.texts.front()))](
          const std::stop_token&) { *request = workbench::readRequest(*text); });
  inbox.reading = Reading{task, std::move(request), bytes};
  clerk_.push(std::move(task));
  return false;
}

Desk::Message Desk::taken(hmi::BrowserId browser, Inbox& inbox, hmi::Server& server) {
  Message message{browser, std::move(inbox.texts.front()), nullptr};
  inbox.texts.pop_front();
  if (inbox.reading) message.request = std::move(inbox.reading->request);
  inbox.bytes -= inbox.reading ? inbox.reading->bytes : message.text.size();
  inbox.reading.reset();
  if (inbox.paused && inbox.texts.size() <= kMostTexts / 2 && inbox.bytes <= kMostBytes / 2) {
    inbox.paused = false;
    server.resume(browser);
  }
  return message;
}

// The browsers take turns.
std::optional<Desk::Message> Desk::next(hmi::Server& server) {
  const std::lock_guard lock(mutex_);
  auto one = inboxes_.upper_bound(last_);
  for (std::size_t count = 0; count < inboxes_.size(); ++count, ++one) {
    if (one == inboxes_.end()) one = inboxes_.begin();
    const hmi::BrowserId browser = one->first;
    // Without its greeting it is not known yet.
    if (!browsers_.contains(browser) || one->second.texts.empty()) continue;
    if (workbenches_.busy(browser) || server.waiting(browser) > kMostUnread) continue;
    if (!ready(browser, one->second)) continue;
    last_ = browser;
    return taken(browser, one->second, server);
  }
  return std::nullopt;
}

// An empty answer: it comes later.
void Desk::handle(Message message, hmi::Server& server) {
  current_ = message.browser;
  watchdog_.enter("a request", current_);
  std::string answer = message.request
                           ? workbenches_.handle(message.browser, std::move(*message.request))
                           : workbenches_.handle(message.browser, message.text);
  if (!answer.empty()) server.send(message.browser, std::move(answer));
  current_ = 0;
}

// True: there are more.
bool Desk::handleSome(hmi::Server& server, const Ended& enough) {
  do {
    auto message = next(server);
    if (!message) return false;
    handle(std::move(*message), server);
  } while (!enough());
  return true;
}

// A browser that has not read the last frame yet gets none: the next one will have it all. True:
// there was no time for some.
bool Desk::frame(hmi::Server& server, const Ended& enough) {
  const std::int64_t now = wallClock();
  if (unframed_.empty()) {
    if (now < nextFrame_ || browsers_.empty()) return false;
    nextFrame_ = now + kFrame;
    watchdog_.enter("what all browsers see");
    workbenches_.beginFrame(now / 1'000'000);
    unframed_ = browsers_;
  }
  while (!unframed_.empty() && !enough()) {
    const hmi::BrowserId browser = *unframed_.begin();
    unframed_.erase(unframed_.begin());
    if (server.waiting(browser) > 0) continue;
    watchdog_.enter("what a browser sees", browser);
    for (std::string& text : workbenches_.events(browser, enough))
      server.send(browser, std::move(text));
  }
  return !unframed_.empty();
}

void Desk::run(hmi::Server& server, const std::function<bool()>& ended) {
  bool over = false;
  while (!over && !(over = ended())) {
    std::int64_t end = 0;
    const Ended enough = [&] { return over || (over = ended()) || wallClock() >= end; };
    const auto begin = [&] { end = wallClock() + kSlice.ns; };
    greet();
    begin();
    bool more = handleSome(server, enough);
    if (over) break;
    if (eachSlice_) eachSlice_();
    more = workbenches_.advance(wallClock, kSlice) || more;
    begin();
    for (auto& [browser, text] : workbenches_.laterAnswers(enough))
      server.send(browser, std::move(text));
    begin();
    more = frame(server, enough) || more;
    if (!more && !over) wait();
  }
  watchdog_.ending();
}

}  // namespace merker::app
