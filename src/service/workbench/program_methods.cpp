// The program: compile, compare, load into the CPU, look at its blocks.
#include "workbench/inherited.h"
#include "workbench/message.h"
#include "workbench/program_rows.h"
#include "workbench/start_declaration.h"
#include "workbench/translated.h"

namespace merker::workbench {
namespace program_methods {
namespace {

using monitor::Feature;

constexpr std::size_t kMostFiles = 1000, kMostBlocks = 10000;

struct Wanted {
  bool all = false;
  std::set<BlockId> blocks{};
};

// The blocks that the request names, or all. P1206 for one that is not there.
Result<Wanted, Problems> wantedBlocks(const Fields& fields, const block::Program& program,
                                      const source::SymbolTable& symbols) {
  if (!fields.has("blocks")) return Wanted{.all = true};
  Wanted wanted;
  const std::vector<std::string> names = fields.texts("blocks", kMostBlocks);
  const monitor::LocationContext context{program, symbols, {}};
  Problems problems = fields.problems();
  for (const std::string& name : names) {
    const auto id = monitor::findBlock(name, context);
    id ? static_cast<void>(wanted.blocks.insert(*id)) : problems.add(id.error());
  }
  if (problems.hasErrors()) return problems;
  return wanted;
}

// What a worker looks at: the program on the disk, that in the CPU, and what the CPU's was made of.
struct Both {
  OfflineRef offline;
  ProgramRef online;
  BuildRef build;

  const block::Program& program(bool cpu) const { return cpu ? *online : *offline->build->program; }
  const source::SymbolTable& symbols() const { return build->project.symbols; }
};

Both both(const Call& call) {
  return {call.shared.offlineRef(), call.plc().program(), call.plc().buildRef()};
}

bool online(const Fields& fields, std::size_t otherwise = 0) {
  return fields.choice("side", {"offline", "online"}, otherwise) == 1;
}

Answer checked(const Offline& offline, const ProjectFolder& folder) {
  Problems problems = offline.build->problems;
  problems.sort();
  Json list = firstOf(problems);
  for (Json& problem : list) relate(problem, folder);
  Json result = {{"problems", std::move(list)},
                 {"more", problems.size() - std::min(problems.size(), kMostProblems)},
                 {"blocks", offline.build->blocks()}};
  if (!offline.build->program) return result;
  result["interfaces"] = interfaceRows(*offline.build->program, offline.sources, folder);
  return result;
}

Answer checkTexts(const Aside& aside, const std::string& project) {
  std::map<std::string, std::string> unsaved;
  if (aside.fields.has("files"))
    for (const Fields& file : aside.fields.objects("files", kMostFiles)) {
      const std::string path = file.text("path");
      unsaved[aside.folder.full(path)] = file.text("text");
    }
  if (!aside.fields.good()) return aside.wrong();
  return checked(offlineOf(project, unsaved, 0, aside.stop), aside.folder);
}

Answer check(const Call& call) {
  Answer answer = elsewhere(call, call.shared.work,
                            [project = call.plc().build().project.path](const Aside& aside) {
                              return checkTexts(aside, project);
                            });
  answer.waits()->newest = call.fields.has("files");
  return answer;
}

Answer refusedLoad(const std::string& reason) {
  return refused(ProblemCode::P1308, "the CPU does not accept blocks", reason);
}

// All that a download needs, made by a worker.
struct Download {
  std::optional<Answer> refused;
  ProgramRef program;
  source::SymbolTable symbols;
  bool all = false;
  std::unique_ptr<Plc> plc;  // for another configuration of the hardware: that is another station
  Listing seen;
};

Download prepared(const Aside& aside, const Both& both, std::optional<station::Engine> engine) {
  const compilation::Build& build = *both.offline->build;
  Download load;
  if (!build.ok()) {
    load.refused = written(build.problems, aside.folder);
    return load;
  }
  const auto wanted = wantedBlocks(aside.fields, *build.program, both.symbols());
  if (!wanted) {
    load.refused = wanted.error();
    return load;
  }
  load.all = wanted->all;
  load.symbols = build.project.symbols;
  if (project::configurationText(build.project) !=
      project::configurationText(both.build->project)) {
    load.plc = std::make_unique<Plc>(both.offline->build);
    load.plc->controller().stop();
    load.plc->use(engine);
    load.seen = aside.folder.list();
    return load;
  }
  load.program = build.program;
  if (wanted->all) return load;
  auto program = std::make_shared<block::Program>(*both.online);
  for (const BlockId id : wanted->blocks) program->insert_or_assign(id, build.program->at(id));
  load.program = std::move(program);
  return load;
}

Answer loadConfiguration(const Call& call, Download& load) {
  if (call.plc().controller().mode() != controller::Mode::Stop)
    return refusedLoad(
        "merker.toml has changed; the hardware configuration is loaded in STOP only");
  if (call.shared.lab)
    return refusedLoad(
        "merker.toml has changed; several stations are loaded anew together, in the view of the "
        "network");
  inherit(*load.plc, call.plc());
  call.shared.show(std::move(load.plc), call.shared.example, std::move(load.seen));
  return empty();
}

Answer load(const Call& call);

Answer loadBlocks(const Call& call, const Both& before, Download& ready) {
  // Another browser was quicker: once more, with what the CPU has now.
  if (call.plc().program() != before.online) return load(call);
  const std::string reason = call.plc().download(ready.program);
  if (!reason.empty()) return refusedLoad(reason);
  call.shared.discard(before.online);
  call.shared.loaded(before.offline->build, std::move(ready.symbols));
  if (ready.all) call.shared.files.loaded();
  return empty();
}

Answer load(const Call& call) {
  const Both now = both(call);
  return elsewhere<Download>(
      call, call.shared.clerk,
      [now, engine = call.shared.engine()](const Aside& aside) {
        return prepared(aside, now, engine);
      },
      [now](const Call& here, Download& made) -> Answer {
        if (made.refused) return std::move(*made.refused);
        if (here.plc().program() != now.online) return load(here);
        if (made.plc) return loadConfiguration(here, made);
        auto ready = std::make_shared<Download>(std::move(made));
        return supplied(here, ready->program,
                        [now, ready](const Call& then) { return loadBlocks(then, now, *ready); });
      });
}

Answer blocks(const Call& call) {
  return elsewhere(call, call.shared.clerk, [both = both(call)](const Aside& aside) -> Answer {
    const bool cpu = online(aside.fields);
    if (!aside.fields.good()) return aside.wrong();
    const compilation::Build& build = cpu ? *both.build : *both.offline->build;
    if (build.isListing())
      return Json{{"blocks", blockRows(build.listings, build.project, aside.folder)}};
    return Json{{"blocks", blockRows(both.program(cpu), both.offline->sources, aside.folder, cpu)}};
  });
}

Answer compare(const Call& call) {
  return elsewhere(call, call.shared.clerk, [both = both(call)](const Aside&) -> Answer {
    if (both.build->isListing())
      return Json{{"blocks", comparison(both.offline->build->listings, both.build->listings)}};
    return Json{{"blocks", comparison(both.program(false), both.program(true))}};
  });
}

// As the project's sources have them that were compiled for the CPU. A block that the project has
// as well must not come into it twice: its source lies in online/, which is compiled only by name.
Answer uploaded(const Aside& aside, const Both& both) {
  const auto wanted = wantedBlocks(aside.fields, *both.online, both.symbols());
  if (!wanted) return wanted.error();
  const auto sources = blockSources(both.build->project.sources, both.symbols());
  Json files = Json::array();
  for (const auto& [id, block] : *both.online) {
    const auto source = sources.find(id);
    const bool named = wanted->all ? id.kind != BlockKind::UDT : wanted->blocks.contains(id);
    if (!named || source == sources.end()) continue;
    const bool known = both.offline->sources.contains(id);
    const std::string path =
        fmt::format("{}{}{}.awl", known ? "online/" : "", name(id.kind), id.number);
    if (auto problem = aside.folder.create(path, source->second.text)) return one(*problem);
    files.push_back(path);
  }
  return Json{{"files", std::move(files)}};
}

Answer upload(const Call& call) {
  return changingFiles(call,
                       [both = both(call)](const Aside& aside) { return uploaded(aside, both); });
}

Result<ProgramRef, Problems> without(const Aside& aside, const ProgramRef& online,
                                     const source::SymbolTable& symbols) {
  const auto wanted = wantedBlocks(aside.fields, *online, symbols);
  if (!wanted) return wanted.error();
  if (wanted->all) return refused(ProblemCode::P1306, "blocks", "a list of blocks");
  auto program = std::make_shared<block::Program>(*online);
  for (const BlockId id : wanted->blocks) program->erase(id);
  return ProgramRef(std::move(program));
}

Answer remove(const Call& call) {
  using Left = Result<ProgramRef, Problems>;
  const ProgramRef online = call.plc().program();
  return elsewhere<Left>(
      call, call.shared.clerk,
      [online, build = call.plc().buildRef()](const Aside& aside) {
        return without(aside, online, build->project.symbols);
      },
      [online](const Call& here, Left& left) -> Answer {
        if (!left) return left.error();
        if (here.plc().program() != online) return remove(here);
        const std::string reason = here.plc().download(*left);
        if (!reason.empty()) return refusedLoad(reason);
        here.shared.discard(online);
        ++here.shared.programRevision;
        here.shared.probesWait = true;
        return empty();
      });
}

struct Shown {
  std::string block;
  bool cpu = false;
  Mnemonics mnemonics = Mnemonics::German;
};

Shown shownBlock(const Fields& fields) {
  return {fields.text("block"), online(fields),
          static_cast<Mnemonics>(fields.choice("mnemonics", {"german", "international"}, 0))};
}

struct Printed {
  monitor::BlockCode code;
  Shown shown;
  const BlockSource* source;  // null: it has none of its own
  const ProjectFolder& folder;
};

// Blocks of the system are the CPU's; a program brings one only if it came from another CPU.
Result<BlockId> blockOf(std::string_view text, const monitor::ProgramCode& program,
                        const source::SymbolTable& symbols) {
  constexpr BlockKind kSystem[] = {BlockKind::SFB, BlockKind::SFC};
  const auto id = monitor::parseBlockId(text, kSystem);
  if (!id) return monitor::findBlock(text, {program, symbols, {}});
  if (program.find(*id)) return *id;
  return makeProblem(ProblemCode::P1308, nowhere(), toString(*id),
                     "it is a block of the CPU, which has no machine code to show");
}

// `print`: of a block of either side.
Answer withBlock(const Call& call, Json (*print)(const Printed&)) {
  return elsewhere(
      call, call.shared.clerk, [both = both(call), print](const Aside& aside) -> Answer {
        const Shown shown = shownBlock(aside.fields);
        if (!aside.fields.good()) return aside.wrong();
        const compilation::Build& build = shown.cpu ? *both.build : *both.offline->build;
        const monitor::ProgramCode program =
            build.isListing() ? monitor::ProgramCode(build.listings) : both.program(shown.cpu);
        const auto id = blockOf(shown.block, program, both.symbols());
        if (!id) return one(id.error());
        std::map<BlockId, BlockSource> online;
        if (shown.cpu) online = blockSources(build.project.sources, both.symbols());
        const auto& sources = shown.cpu ? online : both.offline->sources;
        const auto source = sources.find(*id);
        return print({*program.find(*id), shown,
                      source == sources.end() ? nullptr : &source->second, aside.folder});
      });
}

Answer showListing(const Call& call) {
  return withBlock(call, [](const Printed& printed) {
    return Json{{"text", listing(printed.code, printed.shown.mnemonics)}};
  });
}

Answer showMachineCode(const Call& call) {
  return withBlock(call, [](const Printed& printed) {
    return machineCodeRows(printed.code, printed.shown.mnemonics, printed.source, printed.folder);
  });
}

Answer complete(const Call& call) {
  return elsewhere(call, call.shared.clerk,
                   [offline = call.shared.offlineRef()](const Aside&) -> Answer {
                     return completion(*offline->build);
                   });
}

Answer startInformation(const Call& call) {
  const auto ob = static_cast<std::uint32_t>(call.fields.integer("ob", 1, 255));
  if (!call.fields.good()) return call.fields.problems();
  return Json{{"text", startDeclaration(ob)}};
}

// The first rows; how many more there are. An operand shows the rest.
Answer referenced(const Aside& aside, const compilation::Build& build) {
  constexpr std::size_t kMost = 20'000;
  const std::string operand = aside.fields.text("operand", "");
  if (!aside.fields.good()) return aside.wrong();
  auto list = monitor::crossReferences(build.code(), build.project.symbols,
                                       {.library = build.library.get()});
  if (!operand.empty()) {
    auto some = monitor::filtered(list, operand, build.operands(),
                                  monitor::filterWords(build.code()), build.project.symbols);
    if (!some) return one(some.error());
    list = std::move(*some);
  }
  const std::size_t more = list.size() - std::min(list.size(), kMost);
  if (more > 0) list.erase(list.begin() + kMost, list.end());
  return Json{{"rows", referenceRows(list, aside.folder)}, {"more", more}};
}

Answer references(const Call& call) {
  return elsewhere(call, call.shared.clerk,
                   [offline = call.shared.offlineRef()](const Aside& aside) {
                     return referenced(aside, *offline->build);
                   });
}

constexpr Method kMethods[] = {
    {"program.check", Needs::Plc, check, Kind::Compiles},
    {"program.load", Needs::ableOn(Feature::Download), load, Kind::Compiled},
    {"program.blocks", Needs::able(Feature::Blocks), blocks, Kind::Compiled},
    {"program.compare", Needs::able(Feature::Blocks), compare, Kind::Compiled},
    {"program.upload", Needs::able(Feature::Download), upload, Kind::Compiled},
    {"program.delete", Needs::ableOn(Feature::Download), remove},
    {"program.listing", Needs::able(Feature::Blocks), showListing, Kind::Compiled},
    {"program.machineCode", Needs::able(Feature::Blocks), showMachineCode, Kind::Compiled},
    {"program.completion", Needs::able(Feature::Completion), complete, Kind::Compiled},
    {"program.startInformation", Needs::able(Feature::Completion), startInformation},
    {"program.references", Needs::able(Feature::References), references, Kind::Compiled},
};

}  // namespace
}  // namespace program_methods

std::span<const Method> programMethods() { return program_methods::kMethods; }

}  // namespace merker::workbench
