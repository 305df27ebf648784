#include "simulator/step_words.h"

#include <array>

#include "base/text.h"
#include "simulator/line.h"

namespace merker::simulator {
namespace {

using Rest = StepWord::Rest;

constexpr std::array kSteps = {
    StepWord{"set", Rest::Assignments, StepKind::Set},
    StepWord{"wait", Rest::Wait, StepKind::Wait},
    StepWord{"expect", Rest::Expectation, StepKind::Expect},
    StepWord{"run", Rest::None, StepKind::Run},
    StepWord{"stop", Rest::None, StepKind::Stop},
    StepWord{"cold restart", Rest::None, StepKind::ColdRestart},
    StepWord{"warm restart", Rest::None, StepKind::WarmRestart},
    StepWord{"hot restart", Rest::None, StepKind::HotRestart},
    StepWord{"switch", Rest::Switch, StepKind::Switch},
    StepWord{"power off", Rest::None, StepKind::PowerOff},
    StepWord{"power on unbuffered", Rest::None, StepKind::PowerOnUnbuffered},
    StepWord{"power on", Rest::None, StepKind::PowerOn},
    StepWord{"battery low", Rest::None, StepKind::BatteryLow},
    StepWord{"battery good", Rest::None, StepKind::BatteryGood},
    StepWord{"remove card", Rest::None, StepKind::RemoveCard},
    StepWord{"trigger", Rest::Trigger, StepKind::Trigger},
    StepWord{"memory reset", Rest::None, StepKind::MemoryReset},
    StepWord{"copy RAM to ROM", Rest::None, StepKind::CopyRamToRom},
    StepWord{"force", Rest::Assignments, StepKind::Force},
    StepWord{"unforce", Rest::None, StepKind::Unforce},
    StepWord{"fault", Rest::Fault, StepKind::Fault},
    StepWord{"terminal", Rest::Terminals, StepKind::Terminal},
    StepWord{"pulses", Rest::Pulses, StepKind::Signal},
    StepWord{"encoder", Rest::Encoder, StepKind::Signal},
    StepWord{"plant", Rest::Plants, StepKind::Plant},
    StepWord{"repeat", Rest::Count, StepKind::Repeat},
    StepWord{"end", Rest::End, StepKind::Repeat},
    StepWord{"scenario", Rest::Scenario, StepKind::Wait},
};

// Takes the words of `wanted` off `line` if it begins with them.
bool takeWords(std::string_view& line, std::string_view wanted) {
  std::string_view rest = line;
  while (!wanted.empty()) {
    const std::string_view word = takeWord(rest);
    if (!equalsIgnoreCase(word, takeWord(wanted))) return false;
  }
  line = rest;
  return true;
}

}  // namespace

const StepWord* takeStepWord(std::string_view& line) {
  for (const StepWord& step : kSteps)
    if (takeWords(line, step.words)) return &step;
  return nullptr;
}

bool expectsSignal(std::string_view line) {
  if (!equalsIgnoreCase(takeWord(line), "expect")) return false;
  const std::string_view word = takeWord(line);
  return equalsIgnoreCase(word, "pulses") || equalsIgnoreCase(word, "encoder");
}

std::string stepWords() {
  std::string list;
  for (const StepWord& step : kSteps) {
    if (step.rest == Rest::Scenario) continue;
    if (!list.empty()) list += ", ";
    list += step.words;
  }
  return list;
}

}  // namespace merker::simulator
