#include "work_thread.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>

namespace merker::app {
namespace {

using workbench::Work;

// A process ends as a whole.
std::atomic<bool> leftBehind = false;

// The PLC and the server come first where there are fewer processors than threads.
void stepBack() {
  constexpr int kLater = 10;
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kLater);
}

}  // namespace

struct WorkThread::State {
  std::mutex mutex;
  std::condition_variable arrived, ended;
  std::deque<Work> waiting;
  std::map<std::uint64_t, std::uint64_t> served;  // when the browser had its last turn
  std::uint64_t turn = 0;
  Work current;
  bool ending = false, gone = false;

  Work next();
};

// Who had no turn for the longest time.
Work WorkThread::State::next() {
  const auto when = [this](const Work& work) { return served[work->owner()]; };
  const auto best = std::ranges::min_element(waiting, {}, when);
  Work work = *best;
  waiting.erase(best);
  constexpr std::size_t kMostRemembered = 1000;
  if (served.size() > kMostRemembered) served.clear();
  served[work->owner()] = ++turn;
  return work;
}

WorkThread::WorkThread() : state_(std::make_shared<State>()), thread_(run, state_) {}

WorkThread::~WorkThread() {
  constexpr auto kLongestWait = std::chrono::seconds(1);
  bool gone = false;
  {
    std::unique_lock lock(state_->mutex);
    state_->ending = true;
    if (state_->current) state_->current->cancel();
    state_->arrived.notify_one();
    gone = state_->ended.wait_for(lock, kLongestWait, [this] { return state_->gone; });
  }
  gone ? thread_.join() : thread_.detach();
  if (!gone) leftBehind = true;
}

bool WorkThread::anyLeftBehind() { return leftBehind; }

void WorkThread::push(Work work) {
  {
    const std::lock_guard lock(state_->mutex);
    std::erase_if(state_->waiting, [](const Work& one) { return one->cancelled(); });
    state_->waiting.push_back(std::move(work));
  }
  state_->arrived.notify_one();
}

void WorkThread::run(const std::shared_ptr<State>& state) {
  stepBack();
  std::unique_lock lock(state->mutex);
  while (true) {
    state->arrived.wait(lock, [&] { return state->ending || !state->waiting.empty(); });
    if (state->ending) break;
    state->current = state->next();
    const Work work = state->current;
    lock.unlock();
    work->carryOut();
    lock.lock();
    state->current = nullptr;
  }
  state->gone = true;
  state->ended.notify_one();
}

}  // namespace merker::app
