// Virtual time tied to the wall clock.
#pragma once

#include <functional>

#include "bell.h"
#include "plc/controller.h"

namespace merker::app {

// Keeps Ctrl-C and the request to end (SIGINT, SIGTERM) back until runRealTime asks for them. Call
// before it.
void holdSignals();
// Whether one of these signals has come.
bool endAsked();
// The same, and the signal stays: somebody else takes it.
bool endWaits();
// The process ends by such a signal, whatever its other threads do: as after `kill`.
[[noreturn]] void endAtOnce();
// From here on they end the process again by themselves.
void releaseSignals();
class SerialLink;
// Who looks at the station from outside.
struct Guests {
  std::function<void()> slice;  // in front of each slice of time
  // Somebody waits for the end of a cycle: the next slice is a short one.
  std::function<bool()> waiting = [] { return false; };
  Bell* bell = nullptr;  // ends the pause between two slices
};

// Lets the station run as fast as time passes, until one of these signals comes or the CPU is in
// STOP. `link`: of its serial interface with the outside; null: none. With guests somebody outside
// can start the CPU, so that its STOP is no end. Not beyond `end`.
void runRealTime(controller::Controller& station, SerialLink* link = nullptr,
                 const Guests& guests = {}, Instant end = Instant::never());

}  // namespace merker::app
