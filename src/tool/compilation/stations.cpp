#include "compilation/stations.h"

#include <algorithm>
#include <filesystem>

#include "base/text.h"
#include "serial/parameters.h"

namespace merker::compilation {
namespace {

const io::Module* serialModule(const project::Project& project) {
  if (!project.hardware) return nullptr;
  const auto& modules = project.hardware->modules;
  const auto found = std::ranges::find_if(modules, [](const io::Module& module) {
    return module.type->kind == ModuleKind::PointToPoint && module.parameters.serial;
  });
  return found == modules.end() ? nullptr : &*found;
}

// RS 485 has one pair, RS 422 two.
bool twoWire(const io::Module& module) {
  return module.parameters.serial->line.mode == serial::Mode::TwoWire;
}

void requireLine(Build& build, const project::OtherStation& station) {
  const io::Module* const own = serialModule(build.project);
  const io::Module* const other = serialModule(build.partner->project);
  if (own == nullptr)
    build.problems.add(ProblemCode::P0993, station.named);
  else if (other == nullptr)
    build.problems.add(ProblemCode::P0704, station.named, "folder",
                       "a project with a serial interface ([[module]] with slot = \"2.1\")");
  else if (twoWire(*own) != twoWire(*other))
    build.problems.add(ProblemCode::P0704, station.named, "folder",
                       "a project whose X27 is wired as this one: both with mode = \"RS485\", or "
                       "both without");
}

// The text behind "Press/" or "partner."; empty if it is an operand of this station.
std::string_view behindName(std::string_view text, const std::string& name) {
  for (const std::string& prefix : {name + '/', std::string(kPartner)})
    if (equalsIgnoreCase(text.substr(0, prefix.size()), prefix))
      return trim(text.substr(prefix.size()));
  return {};
}

// "Foo/E 0.0"; a symbol may have a slash in it.
std::string_view unknownStation(std::string_view text) {
  const auto slash = text.find('/');
  return slash == std::string_view::npos || text.find('"') < slash ? std::string_view{}
                                                                   : text.substr(0, slash);
}

}  // namespace

void addStation(Build& build) {
  if (build.project.stations.empty()) return;
  const project::OtherStation& station = build.project.stations.front();
  const auto folder = std::filesystem::path(build.project.folder) / station.folder;
  project::Project other =
      project::load(folder.lexically_normal().string(), "", {}, build.project.problems.stop());
  if (other.control)
    return build.problems.add(ProblemCode::P0704, station.named, "folder",
                              "the project folder of a SIMATIC S7");
  other.stations.clear();  // it has this one, whatever its own project says
  const bool unreadable = other.unreadable;
  auto partner = std::make_shared<Build>(compilation::build(std::move(other), false));
  requireOb1(*partner);
  requireWorkMemory(*partner);
  build.problems.append(partner->problems);
  build.partner = std::move(partner);
  if (!unreadable) requireLine(build, station);
}

simulator::Resolver withStation(const Build& build, const simulator::Resolver& own,
                                const simulator::Resolver& others) {
  return [name = build.project.stations.front().name, own, others](
             std::string_view text, const Position& at) -> Result<address::Reference> {
    const std::string_view rest = behindName(text, name);
    const std::string_view unknown = rest.empty() ? unknownStation(text) : std::string_view{};
    if (!unknown.empty())
      return makeProblem(ProblemCode::P0704, at, unknown, "the name of a [[station]]: " + name);
    if (rest.empty()) return own(text, at);
    auto reference = others(rest, at);
    if (!reference) return reference;
    reference->partner = true;
    reference->text = text;
    return reference;
  };
}

}  // namespace merker::compilation
