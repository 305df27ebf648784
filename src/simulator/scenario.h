// A scenario (*.scn) as values: steps in order, each with its place in the file
// (docs/formats/scenario.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "block/check.h"
#include "clock/instant.h"
#include "controller/controller.h"
#include "simulator/device_steps.h"
#include "simulator/plant_steps.h"
#include "simulator/signal_steps.h"
#include "simulator/stack_steps.h"
#include "simulator/term.h"
#include "simulator/terminal_steps.h"
#include "source/source_file.h"

namespace merker::simulator {

struct Assignment {
  Term operand, value;
};

struct Expectation {
  enum class What : std::uint8_t {
    Values,
    Mode,
    Diagnostics,
    Terminal,
    Led,
    Plant,
    Stack
  } what = What::Values;
  Term left, right;  // Values
  block::Relation relation = block::Relation::Equal;
  controller::Mode mode = controller::Mode::Run;  // Mode: = or <>
  TerminalValue terminal;                         // Terminal: relation to its value
  PlantValue plant;                               // Plant: the same
  StackField stack;                               // Stack: relation to its value
  std::string words;                              // Diagnostics: what an entry contains
  LedMember led = nullptr;                        // Led: which, = or <> which light
  cpu::Light light = cpu::Light::On;
  enum class When : std::uint8_t { Now, During, Within } when = When::Now;
  bool partner = false;  // Mode, Diagnostics: of the coupled control
  Duration duration;     // During, Within
};

enum class StepKind : std::uint8_t {
  Set,
  Wait,
  WaitCycles,
  Expect,
  Run,
  Stop,
  ColdRestart,
  WarmRestart,
  HotRestart,
  PowerOff,
  PowerOn,
  PowerOnUnbuffered,
  BatteryLow,
  BatteryGood,
  RemoveCard,
  Switch,
  Trigger,
  MemoryReset,
  CopyRamToRom,
  Force,
  Unforce,
  Fault,
  Terminal,
  Signal,
  Plant,
  Repeat
};

struct Step {
  StepKind kind = StepKind::Wait;
  Position position;
  std::string text;                     // as written
  bool partner = false;                 // the coupled control does it
  std::vector<Assignment> assignments;  // Set, Force
  Duration duration;                    // Wait
  std::uint64_t count = 0;              // WaitCycles, Repeat
  Expectation expectation;
  FaultStep fault;                                                 // Fault
  SignalStep signal;                                               // Signal
  std::vector<TerminalValue> terminals;                            // Terminal
  std::vector<PlantValue> plants;                                  // Plant
  cpu::SwitchPosition switchPosition = cpu::SwitchPosition::RunP;  // Switch
  cpu::Trigger trigger{};                                          // Trigger
  std::vector<Step> body;                                          // Repeat
};

struct Scenario {
  std::string name;
  Position position;
  std::vector<Step> steps;
};

// Reads all scenarios of a file; steps before the first `scenario` line form one named after the
// file. Lines with problems are left out.
std::vector<Scenario> parseScenarios(const source::SourceFile& file, Problems& problems);

// Binds all operands to the program, terminals and faults to the modules, signals to the plants,
// and checks that values fit. `hardware`: null without a hardware configuration.
void resolve(Scenario& scenario, const Resolver& resolver, Problems& problems,
             const io::Configuration* hardware = nullptr,
             const plant::Configuration* plants = nullptr);

// "set E 0.0 = 1, MW 10 = 5" without the word set: also what `merker run --set` takes. Texts are
// views into `file`.
std::vector<Assignment> parseAssignments(const source::SourceFile& file, std::string_view text,
                                         Problems& problems);
void resolve(Assignment& assignment, const Resolver& resolver, Problems& problems);
// Writes or forces the value; the reason if that is not possible, else empty.
std::string apply(const Assignment& assignment, bool force, controller::Controller& plc);

}  // namespace merker::simulator
