// Actions of users with their times, recorded and played back in virtual time (S7-SIM-13;
// docs/formats/recording.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "clock/instant.h"
#include "workbench/json.h"

namespace merker::workbench {

struct Action {
  Duration at;  // since the beginning
  std::shared_ptr<const Json> request;
};

// One line for each; P1321 for one that is none.
std::string recordingText(const std::vector<Action>& actions);
Result<std::vector<Action>, Problems> parseRecording(const std::string& path,
                                                     std::string_view text);

// Whether it is a request that is recorded (Kind::Action).
bool isAction(const std::string& method);

class Recorder {
 public:
  // The bytes are those of the requests without fields that mean nothing.
  static constexpr std::size_t kMost = 100'000, kMostBytes = 4 << 20;

  void start(Instant now);
  void stop();
  // Something that a browser did. When the recording is full nothing more comes into it.
  void note(const Json& request, Instant now);
  bool on() const { return on_; }
  bool full() const { return full_; }
  Instant begin() const { return begin_; }
  const std::vector<Action>& actions() const { return actions_; }

 private:
  bool on_ = false, full_ = false;
  Instant begin_;
  std::size_t bytes_ = 0;
  std::vector<Action> actions_;
};

class Player {
 public:
  enum class State : std::uint8_t { None, Playing, Paused, Ended, Failed };

  void start(std::string path, std::vector<Action> actions, Instant now);
  void stop() { *this = {}; }
  // The recording waits while the CPU goes on.
  void pause(bool paused, Instant now);
  // Ends it; what an action was refused with.
  void fail(Json problem) { state_ = State::Failed, problem_ = std::move(problem); }

  // When the next action is due.
  Instant next() const;
  // That action, and on to the one behind it.
  std::shared_ptr<const Json> take();

  State state() const { return state_; }
  // {path, actions, done, state, problem?}
  Json describe() const;

 private:
  State state_ = State::None;
  std::string path_;
  std::vector<Action> actions_;
  std::size_t done_ = 0;
  Instant begin_, pausedAt_;
  Json problem_;
};

}  // namespace merker::workbench
