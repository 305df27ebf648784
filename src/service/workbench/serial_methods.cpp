// The serial line: who watches it, and what its partner does (as scenarios do with `serial`).
#include "scenario/step.h"
#include "scenario/step_line.h"
#include "serial/serial_port.h"
#include "workbench/method.h"

namespace merker::workbench {
namespace serial_methods {
namespace {

using Does = simulator::steps::Serial::Does;

serial::Coupling* couplingOf(const Call& call) {
  return simulator::steps::couplingOf(call.plc().controller());
}

Answer watch(const Call& call) {
  const bool on = call.fields.flag("on");
  if (!call.fields.good()) return call.fields.problems();
  call.browser.serial = {.on = on};
  serial::Coupling* const coupling = couplingOf(call);
  return Json{{"line", coupling == nullptr ? Json(nullptr)
                                           : serialLine(*coupling, call.shared.serialOutside())}};
}

// Who is connected to the outside is no partner of its own.
bool needsPartner(Does does) {
  return does == Does::Answer || does == Does::Partner || does == Does::JobSend ||
         does == Does::JobFetch || does == Does::Memory;
}

Answer perform(const Call& call, const std::string& text) {
  const source::SourceFile file("", text);
  Problems problems;
  const simulator::StepLine line(file, file.line(1), file.line(1), problems);
  simulator::steps::Serial step;
  if (!step.parse(line)) return withoutPlace(problems);
  const std::string outside = call.shared.serialOutside().connection;
  if (!outside.empty() && needsPartner(step.does))
    return refused(ProblemCode::P1308, "X27", "it is connected to " + outside);
  simulator::TestResult result;
  simulator::StepRun run(call.plc().controller(), result);
  if (run.run({simulator::Step{nowhere(), text, false, std::move(step)}})) return empty();
  return refused(ProblemCode::P1308, "X27", result.failures.front().message);
}

// A step of a scenario without its beginning: send "ABC" CR
Answer act(const Call& call) {
  const std::string step = call.fields.name("step", Fields::kLongestValue);
  if (!call.fields.good()) return call.fields.problems();
  if (couplingOf(call) == nullptr) return refused(ProblemCode::P0993);
  return perform(call, "X27 " + step);
}

constexpr Method kMethods[] = {
    {"serial.watch", Needs::Plc, watch},
    {"serial.do", Needs::Plc, act, Kind::Action},
};

}  // namespace
}  // namespace serial_methods

std::span<const Method> serialMethods() { return serial_methods::kMethods; }

}  // namespace merker::workbench
