// Projects: examples, wizard, folders (S7-MGR-01).
#include <algorithm>

#include "catalogue/cpu_model.h"
#include "softplc/sinumerik_model.h"
#include "workbench/elsewhere.h"
#include "workbench/look.h"
#include "workbench/neighbours.h"
#include "workbench/packing.h"

namespace merker::workbench {
namespace project_methods {
namespace {

Answer rows(const Workspace& workspace, const std::vector<std::string>& recent) {
  Json examples = Json::array(), templates = Json::array(), models = Json::array();
  for (const Example& one : workspace.examples())
    examples.push_back({{"id", one.id},
                        {"title", one.title},
                        {"description", one.description},
                        {"copied", one.copied}});
  for (const Template& one : Workspace::templates())
    templates.push_back({{"id", one.id}, {"title", one.title}});
  for (const CpuModel& model : cpuModels()) models.push_back(model.keyword);
  Json sinumerik = Json::array();
  for (const SinumerikModel& model : sinumerikModels()) sinumerik.push_back(model.name);
  return Json{{"examples", std::move(examples)},  {"templates", std::move(templates)},
              {"models", std::move(models)},      {"sinumerik", std::move(sinumerik)},
              {"projects", workspace.projects()}, {"recent", workspace.named(recent)},
              {"folder", workspace.folder()}};
}

Answer list(const Call& call) {
  return elsewhere(call, call.shared.clerk,
                   [workspace = call.shared.workspace, recent = call.shared.recent](const Aside&) {
                     return rows(workspace, recent);
                   });
}

enum class Origin { Own, Example, New };

// A new project comes with a CPU out of the box: empty, its switch at STOP; to load and RUN are the
// steps of a person (S7-SIM-08, -09).
std::unique_ptr<Plc> plcOf(BuildRef build, Origin origin) {
  if (origin != Origin::New) return std::make_unique<Plc>(std::move(build));
  auto controller = withoutProgram(*build);
  controller->stop();
  return std::make_unique<Plc>(std::move(build), std::move(controller));
}

// A project that is ready to be shown.
struct Opened {
  std::optional<Answer> refused;
  std::string folder;
  std::unique_ptr<Plc> plc;
  std::shared_ptr<Laboratory> lab;  // in place of it
  Listing seen;
};

Opened openedNetwork(project::Project project, std::optional<station::Engine> engine) {
  Opened ready;
  Problems problems;
  const ProjectFolder folder(project.folder);
  ready.lab = makeLaboratory(std::move(project), engine, problems);
  if (ready.lab)
    ready.seen = folderOf(ready.lab->plcs[0]->build().project).list();
  else
    ready.refused = written(problems, folder);
  return ready;
}

Opened opened(const Result<std::string>& folder, Origin origin,
              std::optional<station::Engine> engine, const std::stop_token& stop) {
  Opened ready;
  if (!folder) {
    ready.refused = one(folder.error());
    return ready;
  }
  if (project::Project all = project::load(*folder, {}, {}, stop); all.network) {
    ready = openedNetwork(std::move(all), engine);
    ready.folder = *folder;
    return ready;
  }
  const Offline offline = offlineOf(*folder, {}, 0, stop);
  const project::Project& project = offline.build->project;
  if (project.unreadable) {
    ready.refused = written(offline.build->problems, ProjectFolder(project.folder));
    return ready;
  }
  ready.folder = *folder;
  ready.plc = plcOf(offline.build, origin);
  ready.plc->use(engine);
  ready.seen = folderOf(project).list();
  return ready;
}

// Two PLCs would write the same files.
std::optional<Problems> elsewhereOpen(const Shared& shared, const std::string& folder) {
  const std::size_t who = shared.neighbours == nullptr ? 0 : shared.neighbours->whoHas(folder);
  if (who == 0 || who == shared.plcNumber) return std::nullopt;
  return refused(ProblemCode::P1308, folder, fmt::format("PLC {} has it open", who));
}

// `folder` finds or makes it, in the thread of the worker.
Answer openFolder(const Call& call, Origin origin,
                  std::function<Result<std::string>(const Workspace&)> folder) {
  return elsewhere<Opened>(
      call, call.shared.work,
      [workspace = call.shared.workspace, folder = std::move(folder), origin,
       engine = call.shared.engine()](const Aside& aside) {
        return opened(folder(workspace), origin, engine, aside.stop);
      },
      [origin](const Call& now, Opened& ready) -> Answer {
        if (ready.refused) return std::move(*ready.refused);
        if (auto why = elsewhereOpen(now.shared, ready.folder)) return *why;
        const bool example = origin == Origin::Example;
        if (ready.lab)
          now.shared.show(std::move(ready.lab), 0, example, std::move(ready.seen));
        else
          now.shared.show(std::move(ready.plc), example, std::move(ready.seen));
        // A SINUMERIK has what its listing says: single blocks are not loaded into it.
        if (origin == Origin::New && now.shared.plc->can(monitor::Feature::Download))
          now.shared.files.nothingLoaded();
        now.shared.remember(ready.folder);
        return empty();
      });
}

Answer open(const Call& call) {
  const bool example = call.fields.has("example");
  const std::string name = call.fields.text(example ? "example" : "folder");
  const bool fresh = call.fields.flag("fresh", false);
  const bool german = call.fields.choice("language", {"english", "german"}, 0) == 1;
  if (!call.fields.good()) return call.fields.problems();
  return openFolder(call, example ? Origin::Example : Origin::Own,
                    [example, name, fresh, german](const Workspace& workspace) {
                      return example ? workspace.copyExample(name, fresh, german)
                                     : workspace.folderToOpen(name);
                    });
}

Answer copy(const Call& call) {
  return elsewhere(call, call.shared.helper,
                   [workspace = call.shared.workspace](const Aside& aside) -> Answer {
                     const std::string name = aside.fields.text("name");
                     if (!aside.fields.good()) return aside.wrong();
                     return copyProject(aside.folder, workspace, name, aside.stop);
                   });
}

// Of the open project, of the CPU, or of another project of the workspace.
Answer look(const Call& call) {
  return elsewhere(call, call.shared.helper,
                   [workspace = call.shared.workspace, offline = call.shared.offlineRef(),
                    build = call.plc().buildRef(),
                    program = call.plc().program()](const Aside& aside) -> Answer {
                     const std::string folder = aside.fields.text("folder", "");
                     const bool cpu = aside.fields.choice("side", {"offline", "online"}, 0) == 1;
                     const auto mnemonics = static_cast<Mnemonics>(
                         aside.fields.choice("mnemonics", {"german", "international"}, 0));
                     if (!aside.fields.good()) return aside.wrong();
                     if (cpu) return lookOf(*build, program.get(), mnemonics);
                     if (folder.empty()) return lookOf(*offline->build, nullptr, mnemonics);
                     const auto path = workspace.folderToOpen(folder);
                     if (!path) return one(path.error());
                     const Offline other = offlineOf(*path, {}, 0, aside.stop);
                     if (other.build->project.unreadable)
                       return written(other.build->problems, ProjectFolder(*path));
                     return lookOf(*other.build, nullptr, mnemonics);
                   });
}

// "OB 1", "ob35".
std::optional<std::uint32_t> obNumber(std::string text) {
  std::erase(text, ' ');
  if (text.size() < 3 || text.size() > 5) return std::nullopt;
  if ((text[0] | 0x20) != 'o' || (text[1] | 0x20) != 'b') return std::nullopt;
  const bool digits =
      std::all_of(text.begin() + 2, text.end(), [](char c) { return c >= '0' && c <= '9'; });
  return digits ? std::optional(static_cast<std::uint32_t>(std::stoul(text.substr(2))))
                : std::nullopt;
}

Answer make(const Call& call) {
  NewProject wanted;
  wanted.name = call.fields.text("name");
  wanted.model = call.fields.text("model", std::string(defaultCpuModel().keyword));
  wanted.form = call.fields.text("template", "empty");
  wanted.mnemonics =
      static_cast<Mnemonics>(call.fields.choice("mnemonics", {"german", "international"}, 0));
  // S7-NET-03: 0 is the programming device, 1 an operator panel.
  wanted.mpiAddress = static_cast<std::uint32_t>(call.fields.integer("mpiAddress", 2, 126, 2));
  const std::string ob = call.fields.text("ob", "OB 1");
  if (!call.fields.good()) return call.fields.problems();
  const auto number = obNumber(ob);
  if (!number) return refused(ProblemCode::P1305, "ob", "an organization block: OB 1");
  wanted.ob = *number;
  return openFolder(call, Origin::New,
                    [wanted](const Workspace& workspace) { return workspace.make(wanted); });
}

// Everything is on the disk already: files.write puts it there at once.
Answer save(const Call&) { return empty(); }

// A browser asks whether anybody is still there.
Answer ping(const Call&) { return empty(); }

Answer close(const Call& call) {
  call.shared.show(nullptr, false, {});
  return empty();
}

constexpr Method kMethods[] = {
    {"projects.list", Needs::Nothing, list},
    {"projects.open", Needs::Nothing, open, Kind::Compiles},
    {"projects.look", Needs::Plc, look, Kind::Compiled},
    {"projects.copy", Needs::Plc, copy, Kind::Compiles},
    {"projects.new", Needs::Nothing, make, Kind::Compiles},
    {"projects.save", Needs::Nothing, save},
    {"projects.close", Needs::Nothing, close},
    {"ping", Needs::Nothing, ping},
};

}  // namespace
}  // namespace project_methods

std::span<const Method> projectMethods() { return project_methods::kMethods; }

}  // namespace merker::workbench
