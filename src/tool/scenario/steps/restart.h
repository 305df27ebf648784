// run, stop, cold restart, warm restart, hot restart.
#pragma once

#include <string>
#include <string_view>

#include "plc/checked_start.h"
#include "plc/hot_restart.h"
#include "scenario/start.h"
#include "scenario/state_text.h"
#include "scenario/steps/bare.h"

namespace merker::simulator::steps {

inline bool hasNone(StepRun& run, std::string_view what) {
  return run.fail("the CPU refuses: " + run.plc().modelName() + " has no " + std::string(what));
}

// What a PLC finds wrong when it starts is an alarm that a scenario may expect.
inline bool restarted(StepRun& run, simulator::Start how) {
  if (restart(run.plc(), how)) return true;
  const auto* const checked = controller::capability<controller::CheckedStart>(run.plc());
  return (checked != nullptr && checked->startFailed()) ||
         run.fail("the CPU refuses" + because(run.plc()));
}

// In STOP a warm restart.
struct Run : Bare {
  static constexpr std::string_view kWords = "run";
  static constexpr bool kPartner = true;

  bool perform(StepRun& run) const {
    if (run.plc().mode() == controller::Mode::Run) return true;
    return run.powered() && restarted(run, &controller::Controller::start);
  }
};

struct Stop : Bare {
  static constexpr std::string_view kWords = "stop";
  static constexpr bool kPartner = true;

  bool perform(StepRun& run) const {
    run.plc().stop();
    return true;
  }
};

struct WarmRestart : Bare {
  static constexpr std::string_view kWords = "warm restart";
  static constexpr bool kPartner = true;

  bool perform(StepRun& run) const {
    return run.powered() && restarted(run, &controller::Controller::warmRestart);
  }
};

struct ColdRestart : Bare {
  static constexpr std::string_view kWords = "cold restart";
  static constexpr bool kPartner = true;

  bool perform(StepRun& run) const {
    if (!run.powered()) return false;
    if (!run.plc().hasColdRestart()) return hasNone(run, "cold restart");
    return restarted(run, &controller::Controller::coldRestart);
  }
};

// Continues where the CPU stopped, on models that can.
struct HotRestart : Bare {
  static constexpr std::string_view kWords = "hot restart";

  bool perform(StepRun& run) const {
    auto* const plc = run.need<controller::HotRestart>();
    if (plc == nullptr || !run.powered()) return false;
    if (!plc->hasHotRestart()) return hasNone(run, plc->kName);
    return plc->hotRestart() ||
           run.fail("the CPU refuses: there is no interrupted program to continue" +
                    because(run.plc()));
  }
};

}  // namespace merker::simulator::steps
