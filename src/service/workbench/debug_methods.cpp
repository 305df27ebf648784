// Program status, breakpoints, single steps (S7-STATE-07, S7-EDIT-21).
#include "workbench/method.h"

namespace merker::workbench {
namespace debug_methods {
namespace {

using monitor::Feature;

// Of a file, of all files: each frame tells them, each download places them anew.
constexpr std::size_t kMostLines = 100, kMostBreakpoints = 200;
// A step that has not ended by then is one into a program that does not come by.
constexpr Duration kLongestStep = Duration::seconds(1);
// What is done of it at once; the rest in further slices.
constexpr Duration kFirstPart = Duration::milliseconds(10);

Result<BlockId> blockOf(const Call& call) {
  if (call.fields.has("block"))
    return monitor::findBlock(call.fields.text("block"), call.monitor().locations({}));
  const std::string file = call.fields.text("file");
  const auto line = call.fields.integer("line", 1, INT32_MAX);
  const auto place = monitor::findLocation(std::to_string(line),
                                           call.monitor().locations(call.shared.folder.full(file)));
  if (!place) return place.error();
  return place->block;
}

Answer show(const Call& call) {
  const auto block = blockOf(call);
  monitor::CallEnvironment environment;
  if (call.fields.has("instance"))
    environment.di = static_cast<std::uint16_t>(call.fields.integer("instance", 1, UINT16_MAX));
  if (!call.fields.good()) return call.fields.problems();
  if (!block) return one(block.error());
  const auto code = call.monitor().program().find(*block);
  if (!code || code->length() == 0) return refused(ProblemCode::P1207, toString(*block));
  const monitor::StatusWish wish{*block, environment};
  call.browser.status.emplace(wish);
  call.shared.wantedStatus[call.id] = wish;
  call.shared.probesWait = true;
  call.shared.placeProbes();  // a cycle may be asked for next
  return Json{{"block", toString(*block)}};
}

Answer hide(const Call& call) {
  call.browser.status.reset();
  call.shared.wantedStatus.erase(call.id);
  call.shared.probesWait = true;
  return empty();
}

Answer setBreakpoints(const Call& call) {
  const std::string file = call.fields.text("file");
  const auto wanted = call.fields.integers("lines", 1, INT32_MAX, kMostLines);
  if (!call.fields.good()) return call.fields.problems();
  std::set<std::uint32_t> lines;
  const monitor::LocationContext here = call.monitor().locations(call.shared.folder.full(file));
  for (const std::int64_t line : wanted) {
    const auto place = monitor::findLocation(std::to_string(line), here);
    if (place) lines.insert(place->line);
  }
  std::size_t others = 0;
  for (const auto& [path, all] : call.shared.breakpoints) others += path == file ? 0 : all.size();
  if (others + lines.size() > kMostBreakpoints)
    return refused(ProblemCode::P1314, kMostBreakpoints, "breakpoints");
  call.shared.breakpoints[file] = lines;
  if (lines.empty()) call.shared.breakpoints.erase(file);
  call.shared.probesWait = true;
  call.shared.placeProbes();
  return Json{{"lines", lines}};
}

Answer go(const Call& call) {
  call.monitor().debugger().run(call.plc().controller().now());
  return empty();
}

Answer step(const Call& call) {
  using monitor::StepKind;
  constexpr StepKind kSteps[] = {StepKind::Into, StepKind::Over, StepKind::Out};
  const std::size_t kind = call.fields.choice("kind", {"into", "over", "out"}, 0);
  if (!call.fields.good()) return call.fields.problems();
  if (call.plc().controller().mode() == controller::Mode::Stop)
    return refused(ProblemCode::P1308, "single steps", "the CPU is in STOP");
  const Instant now = call.plc().controller().now();
  monitor::Debugger& debugger = call.monitor().debugger();
  debugger.beginStep(kSteps[kind], now + kFirstPart);
  if (debugger.stepping()) call.shared.stepEnds = now + kLongestStep;
  return empty();
}

constexpr Method kMethods[] = {
    {"status.show", Needs::able(Feature::Breakpoints), show},
    {"status.hide", Needs::Nothing, hide},
    {"breakpoints.set", Needs::able(Feature::Breakpoints), setBreakpoints},
    {"debug.go", Needs::ableOn(Feature::Breakpoints), go},
    {"debug.step", Needs::ableOn(Feature::Breakpoints), step},
};

}  // namespace
}  // namespace debug_methods

std::span<const Method> debugMethods() { return debug_methods::kMethods; }

}  // namespace merker::workbench
