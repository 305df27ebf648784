#include "watchdog.h"

#include <csignal>
#include <iostream>

#include "real_time.h"

namespace merker::app {
namespace {

constexpr auto kBetweenLooks = std::chrono::milliseconds(100);
// What lasts longer does not end by itself, as far as a user can tell; what lasts on is told again.
constexpr std::int64_t kPatience = 2;
// From the wish to end the program to its end.
constexpr auto kLongestEnd = std::chrono::seconds(4);

std::int64_t secondsOf(std::chrono::steady_clock::duration time) {
  return std::chrono::duration_cast<std::chrono::seconds>(time).count();
}

}  // namespace

Watchdog::Watchdog(std::string command)
    : command_(std::move(command)), thread_([this] { run(); }) {}

Watchdog::~Watchdog() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void Watchdog::tellBy(Tell tell) {
  const std::lock_guard lock(mutex_);
  tell_ = std::move(tell);
}

void Watchdog::enter(std::string_view place, std::uint64_t browser) {
  const std::lock_guard lock(mutex_);
  place_ = place;
  browser_ = browser;
  since_ = Clock::now();
}

void Watchdog::ending() {
  const std::lock_guard lock(mutex_);
  ending_ = true;
  place_ = "the end";
  since_ = Clock::now();
}

void Watchdog::run() {
  std::unique_lock lock(mutex_);
  while (!changed_.wait_for(lock, kBetweenLooks, [this] { return over_; })) {
    const auto now = Clock::now();
    look(now);
    lookForEnd(now);
  }
}

void Watchdog::say(const std::string& what) const {
  std::cerr << command_ << ": " << what << std::endl;
}

void Watchdog::look(Clock::time_point now) {
  const std::int64_t seconds = place_.empty() ? 0 : secondsOf(now - since_);
  if (!told_.empty() && seconds < kPatience) {
    say(told_ + " has ended");
    if (tell_) tell_(told_, 0);
    told_.clear();
  }
  if (seconds < kPatience || (!told_.empty() && seconds < toldSeconds_ + kPatience)) return;
  if (told_.empty()) {
    told_ = place_;
    if (browser_ != 0) told_ += " of browser " + std::to_string(browser_);
    say(told_ + " has not ended for " + std::to_string(seconds) + " s; the PLC waits for it");
  }
  toldSeconds_ = seconds;
  if (tell_) tell_(told_, seconds);
}

// A signal is taken by the PLC's thread between two pieces of work. One that stays is not.
void Watchdog::lookForEnd(Clock::time_point now) {
  if (!ending_ && !endWaits()) {
    endPending_ = false;
    return;
  }
  if (!endPending_) endSince_ = now;
  endPending_ = true;
  if (now - endSince_ < kLongestEnd) return;
  say("ended although " + (place_.empty() ? std::string("the PLC") : place_) + " has not");
  endAtOnce();
}

}  // namespace merker::app
