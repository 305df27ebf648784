#include "desk.h"

#include <chrono>

namespace merker::app {
namespace {

// How long virtual time runs, or nothing happens, before requests are looked at.
constexpr Duration kSlice = Duration::milliseconds(5);
// 30 frames a second.
constexpr std::int64_t kFrame = 33'000'000;

std::int64_t wallClock() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace

void Desk::push(Message message) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(message));
  }
  arrived_.notify_one();
}

std::deque<Desk::Message> Desk::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(waiting_, {});
}

void Desk::wait() {
  std::unique_lock lock(mutex_);
  arrived_.wait_for(lock, std::chrono::nanoseconds(kSlice.ns),
                    [this] { return !waiting_.empty(); });
}

// An empty text: the answer comes later.
void Desk::answer(hmi::Server& server, hmi::BrowserId browser, std::string text) {
  if (!text.empty()) server.send(browser, std::move(text));
}

void Desk::handle(const Message& message, hmi::Server& server) {
  switch (message.kind) {
    case Kind::Opened:
      browsers_.insert(message.browser);
      return workbench_.opened(message.browser);
    case Kind::Closed:
      browsers_.erase(message.browser);
      return workbench_.closed(message.browser);
    case Kind::Received:
      return answer(server, message.browser, workbench_.handle(message.browser, message.text));
  }
}

// A browser that has not read the last frame yet gets none: the next one will have it all.
void Desk::frame(hmi::Server& server, std::int64_t now) {
  if (now < nextFrame_ || browsers_.empty()) return;
  nextFrame_ = now + kFrame;
  workbench_.beginFrame(now / 1'000'000);
  for (const hmi::BrowserId browser : browsers_) {
    if (!server.ready(browser)) continue;
    for (std::string& text : workbench_.events(browser)) server.send(browser, std::move(text));
  }
}

void Desk::run(hmi::Server& server, const std::function<bool()>& ended) {
  while (!ended()) {
    for (const Message& message : take()) handle(message, server);
    const bool more = workbench_.advance(wallClock, kSlice);
    for (auto& [browser, text] : workbench_.laterAnswers())
      answer(server, browser, std::move(text));
    frame(server, wallClock());
    if (!more) wait();
  }
}

}  // namespace merker::app
