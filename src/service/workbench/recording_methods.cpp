// What users do is recorded with its times and played back (S7-SIM-13).
#include "workbench/elsewhere.h"
#include "workbench/project_file.h"

namespace merker::workbench {
namespace recording_methods {
namespace {

constexpr std::string_view kEnding = ".rec";

Instant now(const Call& call) { return call.plc().controller().now(); }

Answer start(const Call& call) {
  call.shared.recorder.start(now(call));
  return empty();
}

// Without a path: what was recorded is thrown away. It ends when it is written: what cannot be
// written is not lost.
Answer stop(const Call& call) {
  Recorder& recorder = call.shared.recorder;
  if (!recorder.on()) return refused(ProblemCode::P1308, "record.stop", "nothing is recorded");
  const bool kept = call.fields.has("path");
  if (kept) pathOf(call.fields, kEnding);
  call.fields.flag("replace", false);
  if (!call.fields.good()) return call.fields.problems();
  const std::size_t count = recorder.actions().size();
  if (!kept) return recorder.stop(), Json{{"actions", count}};
  auto actions = std::make_shared<const std::vector<Action>>(recorder.actions());
  const std::uint64_t number = call.shared.nextLook();
  return elsewhere<Put>(
      call, call.shared.clerk,
      [actions](const Aside& aside) {
        auto problem = putFile(aside.folder, pathOf(aside.fields, kEnding), recordingText(*actions),
                               aside.fields.flag("replace", false));
        return Put{std::move(problem), aside.folder.list()};
      },
      [number, count](const Call& now, Put& put) -> Answer {
        now.shared.take(number, std::move(put.files));
        if (put.problem) return one(*put.problem);
        now.shared.recorder.stop();
        return Json{{"actions", count}};
      });
}

using Actions = Result<std::vector<Action>, Problems>;

Actions read(const Aside& aside) {
  const std::string path = pathOf(aside.fields, kEnding);
  if (!aside.fields.good()) return aside.fields.problems();
  const auto content = aside.folder.read(path);
  if (!content) return one(content.error());
  return parseRecording(path, content->text);
}

Answer play(const Call& call) {
  return elsewhere<Actions>(
      call, call.shared.clerk, read, [](const Call& here, Actions& actions) -> Answer {
        if (!actions) return actions.error();
        const Json result = {{"actions", actions->size()}};
        here.shared.player.start(pathOf(here.fields, kEnding), std::move(*actions), now(here));
        return result;
      });
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
}  // namespace recording_methods

std::span<const Method> recordingMethods() { return recording_methods::kMethods; }

}  // namespace merker::workbench
