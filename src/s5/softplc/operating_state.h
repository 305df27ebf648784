// The operating states of the PLC and what leads from one to the next (S5-OB-01 … -04). What is to
// be done at a change is a matter of the operating system.
#pragma once

#include <cstdint>
#include <optional>

#include "clock/instant.h"

namespace merker::sinumerik {

enum class Mode : std::uint8_t { Off, Stop, Startup, Run, Halt };
enum class Start : std::uint8_t { Cold, Warm };  // Neustart, Wiederanlauf

// Whether instructions are executed.
constexpr bool executes(Mode mode) { return mode == Mode::Startup || mode == Mode::Run; }

class OperatingState {
 public:
  Mode mode() const { return mode_; }
  // The same, in HALT that of the program.
  Mode ofProgram() const { return mode_ == Mode::Halt ? held_.mode : mode_; }

  bool allows(Start kind) const;
  void start(Start kind);
  void run() { mode_ = Mode::Run; }
  void stop() { mode_ = Mode::Stop; }

  void powerOff();
  void powerOn() { mode_ = Mode::Stop; }
  // Whether a warm restart may go on where the power failed.
  bool canContinue() const { return ranBeforePowerOff_ && !warmInterrupted_; }

  // HALT. False: no program runs.
  bool hold(Instant now);
  // How long it lasted; nothing if it was not in HALT.
  std::optional<Duration> resume(Instant now);
  void holdNext() { holdNext_ = executes(mode_); }  // before the next step
  bool holdsNext() const { return holdNext_; }
  bool takeHoldNext();
  Instant heldSince() const { return held_.since; }  // in HALT

 private:
  Mode mode_ = Mode::Stop;
  struct {
    Mode mode = Mode::Stop;  // to go back to
    Instant since;
  } held_;
  bool holdNext_ = false;
  Start startKind_ = Start::Cold;
  bool warmInterrupted_ = false;  // power failed in OB 20 of a warm restart (S5-OB-03)
  bool ranBeforePowerOff_ = false;
};

}  // namespace merker::sinumerik
