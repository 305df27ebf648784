// Looks whether the thread that moves the PLC comes on. What does not end is told with its place;
// the wish to end the program (SIGINT, SIGTERM) is carried out even then.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace merker::app {

class Watchdog {
 public:
  // Seconds that the place has lasted; 0: it has ended.
  using Tell = std::function<void(const std::string& place, std::int64_t seconds)>;

  explicit Watchdog(std::string command);
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  // Called in the watchdog's thread.
  void tellBy(Tell tell);
  // What the PLC's thread begins now; what it did before has ended. `browser`: 0 for none.
  void enter(std::string_view place, std::uint64_t browser = 0);
  // The thread waits for something to do.
  void leave() { enter({}); }
  // The program ends from now on, within a few seconds.
  void ending();

 private:
  using Clock = std::chrono::steady_clock;
  void run();
  void look(Clock::time_point now);
  void lookForEnd(Clock::time_point now);
  void say(const std::string& what) const;

  std::string command_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool over_ = false, ending_ = false, endPending_ = false;
  Tell tell_;
  std::string place_;
  std::uint64_t browser_ = 0;
  Clock::time_point since_ = Clock::now(), endSince_{};
  std::string told_;  // the place that was told to be hanging
  std::int64_t toldSeconds_ = 0;
  std::thread thread_;  // last: it uses the others
};

}  // namespace merker::app
