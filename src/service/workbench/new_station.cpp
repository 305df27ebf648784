#include "workbench/new_station.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/text.h"
#include "compilation/network.h"
#include "project/files.h"
#include "project/subnet_edit.h"
#include "workbench/json.h"
#include "workbench/network_file.h"

namespace merker::workbench {
namespace {

namespace fs = std::filesystem;

std::string nodeText(std::string_view station, std::uint32_t address) {
  return fmt::format("{{station = {}, address = {}}}", tomlText(station), address);
}

// In small letters: the name of its folder.
std::string folderName(std::string_view station) {
  std::string name(station);
  std::ranges::transform(name, name.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c;
  });
  return name;
}

bool isStationName(std::string_view name) {
  constexpr std::string_view kCharacters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";
  return !name.empty() && name.find_first_not_of(kCharacters) == std::string_view::npos;
}

Problem wrongName() {
  return makeProblem(ProblemCode::P1305, nowhere(), "name",
                     "at most 32 letters, digits, '-' and '_'");
}

std::string withStation(const NetworkFile& file, const NewStation& wanted) {
  project::SettingsEdit edit = file.edit();
  edit.addTable("station",
                {{"name", tomlText(wanted.name)}, {"folder", tomlText(folderName(wanted.name))}});
  if (wanted.subnet.empty()) return edit.text();
  project::SubnetEdit subnets(edit.text());
  if (!subnets.kindOf(wanted.subnet).empty()) {
    subnets.setNode(wanted.subnet, wanted.name, std::to_string(wanted.address));
    return subnets.text();
  }
  edit.addTable("subnet", {{"name", tomlText(wanted.subnet)},
                           {"kind", "\"mpi\""},
                           {"highest", wanted.address > 31 ? "126" : "31"},
                           {"nodes", fmt::format("[{}]", nodeText(wanted.name, wanted.address))}});
  return edit.text();
}

std::uint32_t freeCircle(const project::Network& network) {
  std::set<std::uint32_t> used;
  for (const project::GlobalDataRow& row : network.globalData) used.insert(row.circle);
  std::uint32_t number = 1;
  while (used.contains(number)) ++number;
  return number;
}

// The lowest local ID that no connection of the station has.
std::string freeId(const compilation::NetworkBuild& build, std::string_view station) {
  const project::Network& network = *build.project.network;
  const auto number = findStation(network, station);
  std::set<std::uint32_t> used;
  for (const project::StationConnection& one : network.connections) {
    if (one.kind != ConnectionKind::S7) continue;
    if (one.local == number) used.insert(one.id);
    if (one.partner == number && one.partnerId) used.insert(*one.partnerId);
  }
  if (number && *number < build.stations.size())
    for (const auto& one : build.stations[*number].build->project.communication.configured)
      used.insert(one.id);
  std::uint32_t id = 1;
  while (used.contains(id)) ++id;
  return fmt::format("\"W#16#{:X}\"", id);
}

}  // namespace

Result<std::string> addStation(const std::string& path, const NewStation& wanted) {
  if (!isStationName(wanted.name)) return wrongName();
  const NewProject own{wanted.name, wanted.model, wanted.form, wanted.mnemonics, 1, wanted.address};
  if (auto problem = Workspace::wrong(own)) return *problem;
  const NetworkFile file(path);
  if (auto problem = file.problem()) return *problem;
  const std::string text = withStation(file, wanted);
  if (auto problem = firstError(file.with(text).problems)) return *problem;
  const fs::path folder = fs::path(file.folder().folder()) / folderName(wanted.name);
  std::error_code error;
  if (!fs::create_directory(folder, error))
    return error ? makeProblem(ProblemCode::P1313, nowhere(), folder.string(), error.message())
                 : makeProblem(ProblemCode::P1312, nowhere(), folder.string());
  if (auto problem = Workspace::fill(folder.string(), own)) return *problem;
  if (auto problem = file.write(text)) return *problem;
  return path;
}

Result<std::string> addCircle(const std::string& path, const NewCircle& wanted) {
  const NetworkFile file(path);
  if (auto problem = file.problem()) return *problem;
  const project::Project before = file.with(file.edit().text());
  if (!before.network) return path;
  std::string to;
  for (const std::string& one : wanted.to) to += (to.empty() ? "" : ", ") + tomlText(one);
  project::SettingsEdit edit = file.edit();
  edit.addTable("global_data", {{"circle", std::to_string(freeCircle(*before.network))},
                                {"from", tomlText(wanted.from)},
                                {"to", fmt::format("[{}]", to)},
                                {"rate", std::to_string(wanted.rate)}});
  const auto build = compilation::buildNetwork(file.with(edit.text()), false);
  if (auto problem = firstError(build.problems)) return *problem;
  if (auto problem = file.write(edit.text())) return *problem;
  return path;
}

Result<std::string> addLink(const std::string& path, const NewLink& wanted) {
  const NetworkFile file(path);
  if (auto problem = file.problem()) return *problem;
  project::SettingsEdit edit = file.edit();
  const auto before = compilation::buildNetwork(file.with(edit.text()), false);
  if (auto problem = firstError(before.problems)) return *problem;
  std::vector<std::pair<std::string, std::string>> rows = {{"id", freeId(before, wanted.local)},
                                                           {"local", tomlText(wanted.local)},
                                                           {"partner", tomlText(wanted.partner)}};
  if (wanted.both) rows.emplace_back("partner_id", freeId(before, wanted.partner));
  if (!wanted.subnet.empty()) rows.emplace_back("subnet", tomlText(wanted.subnet));
  edit.addTable("connection", rows);
  const auto build = compilation::buildNetwork(file.with(edit.text()), false);
  if (auto problem = firstError(build.problems)) return *problem;
  if (auto problem = file.write(edit.text())) return *problem;
  return path;
}

Result<std::string> makeNetwork(const Workspace& workspace, const std::string& name,
                                const std::string& station, const std::string& from,
                                std::uint32_t address) {
  if (!isStationName(station)) return wrongName();
  if (!project::isFile(project::join(from, kNetworkFile)))
    return makeProblem(ProblemCode::P1308, nowhere(), from,
                       "a single source is no station; it needs a project folder");
  const auto made = workspace.makeFolder(name);
  if (!made) return made.error();
  std::error_code error;
  fs::copy(from, fs::path(*made) / folderName(station), fs::copy_options::recursive, error);
  if (error) return makeProblem(ProblemCode::P1313, nowhere(), from, error.message());
  const std::string text = fmt::format(
      "[project]\nname = {}\n\n[[station]]\nname = {}\nfolder = {}\n\n[[subnet]]\nname = "
      "\"MPI(1)\"\nkind = \"mpi\"\nbaud = \"187.5k\"\nhighest = {}\nnodes = [{}]\n",
      tomlText(name), tomlText(station), tomlText(folderName(station)), address > 31 ? 126 : 31,
      nodeText(station, address));
  if (auto problem = ProjectFolder(*made).create(kNetworkFile, text)) return *problem;
  return *made;
}

}  // namespace merker::workbench
