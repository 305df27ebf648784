// The whole CPU into a file of the project, and back (S7-SIM-13).
#include "cpu/cpu.h"
#include "workbench/project_file.h"
#include "workbench/snapshot_text.h"
#include "workbench/translated.h"

namespace merker::workbench {

std::vector<std::string> hardwareOf(const io::Rack* rack) {
  std::vector<std::string> lines;
  if (rack == nullptr) return lines;
  for (const io::Module& module : rack->configuration().modules)
    lines.push_back(fmt::format("{} {} E {} A {}", module.slotText(), module.title(),
                                module.inputStart ? std::to_string(*module.inputStart) : "-",
                                module.outputStart ? std::to_string(*module.outputStart) : "-"));
  return lines;
}

namespace snapshot_methods {
namespace {

using monitor::Feature;

constexpr std::string_view kEnding = ".state";

std::string keyword(const Call& call) { return std::string(call.blockCpu().model().keyword); }

// The text has at least so many characters: two for each byte of a block. What is far too long is
// not even copied.
std::size_t leastText(Plc& plc) {
  std::size_t bytes = 0;
  for (const cpu::DataBlock& block : plc.blockCpu()->cpu().machine().dataBlocks.all())
    bytes += block.data.size();
  for (const auto& [id, block] : *plc.program())
    bytes += id.kind == BlockKind::DB ? block.actualData.size() : block.code.size();
  return 2 * bytes;
}

// What a STOP has interrupted is not part of the state.
bool insideBlock(Plc& plc) {
  const controller::Mode mode = plc.controller().mode();
  if (mode == controller::Mode::Stop) return false;
  return mode == controller::Mode::Halt || !plc.blockCpu()->cpu().betweenCycles();
}

Result<SavedCpu> taken(Plc& plc, const std::string& path) {
  const station::BlockCpu& machine = *plc.blockCpu();
  if (insideBlock(plc))
    return makeProblem(ProblemCode::P1308, nowhere(), "the state",
                       "the program is paused inside a block; resume it, or stop the CPU");
  if (leastText(plc) > kLargestFile) return tooLong(path, kLargestFile);
  SavedCpu saved{std::string(machine.model().keyword),
                 hardwareOf(plc.rack()),
                 plc.program(),
                 machine.cpu().snapshot(),
                 {}};
  for (const monitor::Forced& one : plc.monitor().forces())
    saved.forces.push_back({one.operand.text, monitor::show(one.operand, one.value,
                                                            monitor::DisplayFormat::Automatic)});
  return saved;
}

using Taken = std::shared_ptr<std::optional<Result<SavedCpu>>>;

Answer write(const Call& call, const std::string& path, const Taken& taken) {
  if (!**taken) return one((*taken)->error());
  return changingFiles(call, [taken, path](const Aside& aside) -> Answer {
    const auto text = snapshotText(path, ***taken, kLargestFile);
    if (!text) return one(text.error());
    return done(putFile(aside.folder, path, *text, aside.fields.flag("replace", false)));
  });
}

// At the end of the cycle, where nothing is half done.
Answer save(const Call& call) {
  const std::string path = pathOf(call.fields, kEnding);
  call.fields.flag("replace", false);
  if (!call.fields.good()) return call.fields.problems();
  auto result = std::make_shared<std::optional<Result<SavedCpu>>>();
  auto work = std::make_shared<Task>(call.id, [result, path, &shared = call.shared](const auto&) {
    result->emplace(taken(*shared.plc, path));
  });
  call.shared.atCycleEnd(work);
  return later(std::move(work),
               [result, path](const Call& now) { return write(now, path, result); });
}

// Why the CPU here is another one; empty if it is alike.
std::string difference(const Call& call, const SavedCpu& saved) {
  if (saved.model != keyword(call)) return fmt::format("CPU {}", saved.model);
  const auto here = hardwareOf(call.plc().rack());
  if (saved.hardware == here) return {};
  for (std::size_t i = 0; i < std::max(here.size(), saved.hardware.size()); ++i)
    if (i >= here.size() || i >= saved.hardware.size() || here[i] != saved.hardware[i])
      return fmt::format("with the module {}",
                         i < saved.hardware.size() ? saved.hardware[i] : "that is missing there");
  return {};
}

// What the memory of the CPU here has in another size; empty if nothing. A damaged file would
// leave the rest of the memory at 0.
std::string misfit(const cpu::Snapshot& saved, const cpu::Snapshot& here) {
  struct Size {
    std::string_view what;
    std::size_t saved, here;
  };
  const block::RetentiveData &a = saved.memory, &b = here.memory;
  for (const Size& size :
       {Size{"bytes of flags", a.flags.size(), b.flags.size()},
        Size{"timers", a.timers.size(), b.timers.size()},
        Size{"counters", a.counters.size(), b.counters.size()},
        Size{"runtime meters", a.meters.size(), b.meters.size()},
        Size{"bytes of process image", saved.images.size(), here.images.size()},
        Size{"bytes of input periphery", saved.inputs.size(), here.inputs.size()},
        Size{"bytes of output periphery", saved.outputs.size(), here.outputs.size()}})
    if (size.saved != size.here)
      return fmt::format("{}: {} instead of {}", size.what, size.saved, size.here);
  return {};
}

// The same of its data blocks.
std::string misfit(const SavedCpu& saved) {
  const auto& values = saved.snapshot.memory.dataBlocks;
  for (const auto& [id, block] : *saved.program) {
    if (id.kind != BlockKind::DB) continue;
    const auto found = std::ranges::find_if(values, [&, number = id.number](const auto& one) {
      return one.number == number && !one.madeByProgram;
    });
    const std::size_t wanted = block.actualData.size();
    const std::size_t bytes = found == values.end() ? 0 : found->bytes.size();
    if (bytes != wanted)
      return fmt::format("bytes of DB {}: {} instead of {}", id.number, bytes, wanted);
  }
  return {};
}

void forceAgain(const Call& call, const SavedCpu& saved) {
  call.monitor().unforceAll();
  for (const SavedForce& one : saved.forces) call.monitor().force(one.operand, one.value);
}

struct Read {
  std::optional<SavedCpu> saved;
  std::optional<Problem> problem;
};

Read read(const Aside& aside, const std::vector<const block::Program*>& known) {
  const std::string path = pathOf(aside.fields, kEnding);
  if (!aside.fields.good()) return {{}, aside.fields.problems().list().front()};
  const auto content = aside.folder.read(path);
  if (!content) return {{}, content.error()};
  auto saved = parseSnapshot(path, content->text, known);
  if (!saved) return {{}, saved.error()};
  return {std::move(*saved), {}};
}

Answer take(const Call& call, const SavedCpu& saved) {
  if (const std::string other = difference(call, saved); !other.empty())
    return refused(ProblemCode::P1319, other, keyword(call));
  for (const std::string& why :
       {misfit(saved.snapshot, call.blockCpu().cpu().snapshot()), misfit(saved)})
    if (!why.empty()) return refused(ProblemCode::P1320, pathOf(call.fields, kEnding), why);
  call.plc().take(saved.snapshot, saved.program);
  forceAgain(call, saved);
  ++call.shared.programRevision;
  call.shared.probesWait = true;
  return empty();
}

Answer load(const Call& call) {
  if (call.shared.lab)
    return refused(ProblemCode::P1308, call.shared.stationName(),
                   "the state of one of several stations cannot be loaded: they share their time");
  return elsewhere<Read>(
      call, call.shared.clerk,
      [online = call.plc().program(), build = call.plc().buildRef()](const Aside& aside) {
        return read(aside, {online.get(), build->program.get()});
      },
      [](const Call& here, Read& read) -> Answer {
        if (read.problem) return Answer(one(*read.problem));
        auto saved = std::make_shared<const SavedCpu>(std::move(*read.saved));
        return supplied(here, saved->program,
                        [saved](const Call& now) { return take(now, *saved); });
      });
}

constexpr Method kMethods[] = {
    {"cpu.save", Needs::ableOn(Feature::Snapshots), save},
    {"cpu.load", Needs::ableOn(Feature::Snapshots), load, Kind::Action},
};

}  // namespace
}  // namespace snapshot_methods

std::span<const Method> snapshotMethods() { return snapshot_methods::kMethods; }

}  // namespace merker::workbench
