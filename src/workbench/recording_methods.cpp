// What users do is recorded with its times and played back (S7-SIM-13).
#include "workbench/method.h"
#include "workbench/project_file.h"

namespace merker::workbench {
namespace {

constexpr std::string_view kEnding = ".rec";

Instant now(const Call& call) { return call.plc().controller().now(); }

Answer start(const Call& call) {
  call.shared.recorder.start(now(call));
  return empty();
}

// Without a path: what was recorded is thrown away.
Answer stop(const Call& call) {
  Recorder& recorder = call.shared.recorder;
  if (!recorder.on()) return refused(ProblemCode::P1308, "record.stop", "nothing is recorded");
  const bool kept = call.fields.has("path");
  const std::string path = kept ? pathOf(call.fields, kEnding) : "";
  const bool replace = call.fields.flag("replace", false);
  if (!call.fields.good()) return call.fields.problems();
  const Json result = {{"actions", recorder.actions().size()}};
  if (kept)
    if (const auto problem = putFile(call.shared, path, recordingText(recorder.actions()), replace))
      return one(*problem);
  recorder.stop();
  return result;
}

Answer play(const Call& call) {
  const std::string path = pathOf(call.fields, kEnding);
  if (!call.fields.good()) return call.fields.problems();
  const auto content = call.shared.folder.read(path);
  if (!content) return one(content.error());
  auto actions = parseRecording(path, content->text);
  if (!actions) return actions.error();
  const Json result = {{"actions", actions->size()}};
  call.shared.player.start(path, std::move(*actions), now(call));
  return result;
}

Answer pause(const Call& call) {
  const bool on = call.fields.flag("on");
  if (!call.fields.good()) return call.fields.problems();
  call.shared.player.pause(on, now(call));
  return empty();
}

Answer end(const Call& call) {
  call.shared.player.stop();
  return empty();
}

constexpr Method kMethods[] = {
    {"record.start", Needs::Plc, start}, {"record.stop", Needs::Plc, stop},
    {"play.start", Needs::Plc, play},    {"play.pause", Needs::Plc, pause},
    {"play.stop", Needs::Plc, end},
};

}  // namespace

std::span<const Method> recordingMethods() { return kMethods; }

}  // namespace merker::workbench
