// The program: compile, compare, load into the CPU, look at its blocks.
#include "workbench/message.h"
#include "workbench/method.h"
#include "workbench/program_rows.h"

namespace merker::workbench {
namespace {

constexpr std::size_t kMostFiles = 1000, kMostBlocks = 10000;

struct Wanted {
  bool all = false;
  std::set<BlockId> blocks{};
};

// The blocks that the request names, or all. P1206 for one that is not there.
Result<Wanted, Problems> wantedBlocks(const Call& call, const block::Program& program) {
  if (!call.fields.has("blocks")) return Wanted{.all = true};
  Wanted wanted;
  const std::vector<std::string> names = call.fields.texts("blocks", kMostBlocks);
  const monitor::LocationContext context{program, call.plc().build().project.symbols, {}};
  Problems problems = call.fields.problems();
  for (const std::string& name : names) {
    const auto id = monitor::findBlock(name, context);
    id ? static_cast<void>(wanted.blocks.insert(*id)) : problems.add(id.error());
  }
  if (problems.hasErrors()) return problems;
  return wanted;
}

const block::Program& programOf(const Call& call, bool online) {
  return online ? call.station().program() : *call.shared.offline().build.program;
}

bool online(const Call& call, std::size_t otherwise = 0) {
  return call.fields.choice("side", {"offline", "online"}, otherwise) == 1;
}

Answer checked(const Call& call, Offline& offline) {
  const compilation::Build& build = offline.build;
  Problems problems = build.problems;
  problems.sort();
  Json list = toJson(problems);
  for (Json& problem : list) relate(problem, call.shared.folder);
  Json result = {{"problems", std::move(list)}, {"blocks", build.blocks()}};
  if (!build.program) return result;
  result["interfaces"] = interfaceRows(*build.program, offline.sources, call.shared.folder);
  return result;
}

Answer check(const Call& call) {
  std::map<std::string, std::string> unsaved;
  if (call.fields.has("files"))
    for (const Fields& file : call.fields.objects("files", kMostFiles)) {
      const std::string path = file.text("path");
      unsaved[call.shared.folder.full(path)] = file.text("text");
    }
  if (!call.fields.good()) return call.fields.problems();
  return compiled(call, call.plc().build().project.path, std::move(unsaved), checked);
}

Answer refusedLoad(const std::string& reason) {
  return refused(ProblemCode::P1308, "the CPU takes no blocks", reason);
}

// Another configuration of the hardware is another station.
bool sameConfiguration(const compilation::Build& a, const compilation::Build& b) {
  return project::configurationText(a.project) == project::configurationText(b.project);
}

Answer loadConfiguration(const Call& call, const compilation::Build& build) {
  if (call.plc().controller().mode() != controller::Mode::Stop)
    return refusedLoad(
        "merker.toml has changed; the hardware configuration is loaded in STOP only");
  const bool example = call.shared.example;
  auto plc = std::make_unique<Plc>(build);
  plc->controller().stop();
  call.shared.show(std::move(plc), example);
  return empty();
}

Answer load(const Call& call) {
  const compilation::Build build = call.shared.offline().build;
  if (!build.ok()) return build.problems;
  const auto wanted = wantedBlocks(call, *build.program);
  if (!wanted) return wanted.error();
  if (!sameConfiguration(build, call.plc().build())) return loadConfiguration(call, build);
  block::Program program = wanted->all ? *build.program : call.station().program();
  for (const BlockId id : wanted->blocks) program.insert_or_assign(id, build.program->at(id));
  const std::string reason =
      call.station().download(std::make_shared<const block::Program>(std::move(program)));
  if (!reason.empty()) return refusedLoad(reason);
  call.shared.loaded(build);
  if (wanted->all) call.shared.files.loaded();
  return empty();
}

Answer blocks(const Call& call) {
  const bool cpu = online(call);
  if (!call.fields.good()) return call.fields.problems();
  const Offline& offline = call.shared.offline();
  return Json{{"blocks", blockRows(programOf(call, cpu), offline.sources, call.shared.folder)}};
}

Answer compare(const Call& call) {
  return Json{{"blocks", comparison(programOf(call, false), programOf(call, true))}};
}

// As the project's sources have them that were compiled for the CPU. A block that the project has
// as well must not come into it twice: its source lies in online/, which is compiled only by name.
Answer upload(const Call& call) {
  const auto wanted = wantedBlocks(call, call.station().program());
  if (!wanted) return wanted.error();
  const project::Project& project = call.plc().build().project;
  const auto sources = blockSources(project.sources, project.symbols);
  Json files = Json::array();
  for (const auto& [id, block] : call.station().program()) {
    const auto source = sources.find(id);
    if (!(wanted->all || wanted->blocks.contains(id)) || source == sources.end()) continue;
    const bool known = call.shared.offline().sources.contains(id);
    const std::string path =
        fmt::format("{}{}{}.awl", known ? "online/" : "", name(id.kind), id.number);
    if (auto problem = call.shared.folder.create(path, source->second.text)) return one(*problem);
    files.push_back(path);
  }
  call.shared.lookAtFiles();
  return Json{{"files", std::move(files)}};
}

Answer remove(const Call& call) {
  const auto wanted = wantedBlocks(call, call.station().program());
  if (!wanted) return wanted.error();
  if (wanted->all) return refused(ProblemCode::P1306, "blocks", "a list of blocks");
  block::Program program = call.station().program();
  for (const BlockId id : wanted->blocks) program.erase(id);
  const std::string reason =
      call.station().download(std::make_shared<const block::Program>(std::move(program)));
  if (!reason.empty()) return refusedLoad(reason);
  ++call.shared.programRevision;
  call.shared.probesWait = true;
  return empty();
}

Answer showListing(const Call& call) {
  const std::string name = call.fields.text("block");
  const bool cpu = online(call);
  const auto mnemonics =
      static_cast<Mnemonics>(call.fields.choice("mnemonics", {"german", "international"}, 0));
  if (!call.fields.good()) return call.fields.problems();
  const block::Program& program = programOf(call, cpu);
  const auto id = monitor::findBlock(name, {program, call.plc().build().project.symbols, {}});
  if (!id) return one(id.error());
  return Json{{"text", listing(program.at(*id), mnemonics)}};
}

Answer complete(const Call& call) { return completion(call.shared.offline().build); }

Answer references(const Call& call) {
  const std::string operand = call.fields.text("operand", "");
  if (!call.fields.good()) return call.fields.problems();
  const compilation::Build& build = call.shared.offline().build;
  monitor::CrossReferenceOptions options;
  options.library = build.library.get();
  auto list = monitor::crossReferences(*build.program, build.project.symbols, options);
  if (!operand.empty()) {
    auto some = monitor::filtered(list, operand, build.operands());
    if (!some) return one(some.error());
    list = std::move(*some);
  }
  return Json{{"rows", referenceRows(list, call.shared.folder)}};
}

constexpr Method kMethods[] = {
    {"program.check", Needs::Plc, check},
    {"program.load", Needs::S7On, load, Kind::Compiled},
    {"program.blocks", Needs::S7, blocks, Kind::Compiled},
    {"program.compare", Needs::S7, compare, Kind::Compiled},
    {"program.upload", Needs::S7, upload, Kind::Compiled},
    {"program.delete", Needs::S7On, remove},
    {"program.listing", Needs::S7, showListing, Kind::Compiled},
    {"program.completion", Needs::S7, complete, Kind::Compiled},
    {"program.references", Needs::S7, references, Kind::Compiled},
};

}  // namespace

std::span<const Method> programMethods() { return kMethods; }

}  // namespace merker::workbench
