// Projects: examples, wizard, folders (S7-MGR-01).
#include <algorithm>

#include "catalogue/cpu_model.h"
#include "workbench/method.h"

namespace merker::workbench {
namespace {

Answer list(const Call& call) {
  const Workspace& workspace = call.shared.workspace;
  Json examples = Json::array(), templates = Json::array(), models = Json::array();
  for (const Example& one : workspace.examples())
    examples.push_back({{"id", one.id}, {"title", one.title}, {"description", one.description}});
  for (const Template& one : Workspace::templates())
    templates.push_back({{"id", one.id}, {"title", one.title}});
  for (const CpuModel& model : cpuModels()) models.push_back(model.keyword);
  return Json{{"examples", std::move(examples)},
              {"templates", std::move(templates)},
              {"models", std::move(models)},
              {"recent", call.shared.recent},
              {"folder", workspace.folder()}};
}

enum class Origin { Own, Example, New };

// A new project comes with a CPU out of the box: empty, its switch at STOP; to load and RUN are the
// steps of a person (S7-SIM-08, -09).
std::unique_ptr<Plc> plcOf(compilation::Build build, Origin origin) {
  if (origin != Origin::New) return std::make_unique<Plc>(std::move(build));
  auto controller = withoutProgram(build);
  controller->stop();
  return std::make_unique<Plc>(std::move(build), std::move(controller));
}

Answer openFolder(const Call& call, const std::string& folder, Origin origin) {
  return compiled(call, folder, {}, [folder, origin](const Call& now, Offline& offline) -> Answer {
    if (offline.build.project.unreadable) return offline.build.problems;
    now.shared.show(plcOf(std::move(offline.build), origin), origin == Origin::Example);
    if (origin == Origin::New) now.shared.files.nothingLoaded();
    now.shared.remember(folder);
    return empty();
  });
}

Answer open(const Call& call) {
  const bool example = call.fields.has("example");
  const std::string name = call.fields.text(example ? "example" : "folder");
  if (!call.fields.good()) return call.fields.problems();
  const auto folder =
      example ? call.shared.workspace.copyExample(name) : call.shared.workspace.folderToOpen(name);
  if (!folder) return one(folder.error());
  return openFolder(call, *folder, example ? Origin::Example : Origin::Own);
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
  const auto folder = call.shared.workspace.make(wanted);
  if (!folder) return one(folder.error());
  return openFolder(call, *folder, Origin::New);
}

// Everything is on the disk already: files.write puts it there at once.
Answer save(const Call&) { return empty(); }

// A browser asks whether anybody is still there.
Answer ping(const Call&) { return empty(); }

Answer close(const Call& call) {
  call.shared.show(nullptr, false);
  return empty();
}

constexpr Method kMethods[] = {
    {"projects.list", Needs::Nothing, list},   {"projects.open", Needs::Nothing, open},
    {"projects.new", Needs::Nothing, make},    {"projects.save", Needs::Nothing, save},
    {"projects.close", Needs::Nothing, close}, {"ping", Needs::Nothing, ping},
};

}  // namespace

std::span<const Method> projectMethods() { return kMethods; }

}  // namespace merker::workbench
