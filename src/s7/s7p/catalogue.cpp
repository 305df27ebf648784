#include "s7p/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "s7p/dbase.h"
#include "s7p/links.h"
#include "s7p/stations.h"

namespace merker::s7p {
namespace {

using archive::folded;

// The part of `path` before `tail`, both without case; nothing if it does not end so.
std::optional<std::string> before(const std::string& path, std::string_view tail) {
  const std::string key = folded(path);
  if (key == tail) return std::string();
  if (key.size() <= tail.size() || !key.ends_with(tail) || key[key.size() - tail.size() - 1] != '/')
    return std::nullopt;
  return path.substr(0, path.size() - tail.size() - 1);
}

// ".../ombstx/offline/00000001/SUBBLK.DBF": the folder above ombstx.
std::optional<std::string> projectOfBlocks(const std::string& folder) {
  const std::string_view offline = archive::folderOf(folder);
  return before(std::string(offline), "ombstx/offline");
}

void readLanguage(const archive::Tree& tree, Project& project) {
  const auto file = tree.open(under(project.folder, "global/language"));
  if (!file) return;
  const std::string text = file->text(200);
  std::size_t start = 0;
  constexpr int kLine = 3;  // the fourth line is the ANSI code page
  for (int line = 0; line < kLine && start != std::string::npos; ++line)
    start = text.find('\n', start) == std::string::npos ? text.size() : text.find('\n', start) + 1;
  unsigned page = 0;
  std::from_chars(text.data() + start, text.data() + text.size(), page);
  project.pageKnown = page != 0;
  if (page != 0) project.page = CodePage(page);
}

// The name in the .s7p: u32 0, its length in a byte, its characters.
std::string projectName(const archive::Tree& tree, const Project& project) {
  for (const auto& entry : tree.below(project.folder)) {
    const std::string key = folded(entry.path);
    const bool beside = archive::folderOf(key) == folded(project.folder);
    if (!beside || !(key.ends_with(".s7p") || key.ends_with(".s7l"))) continue;
    const auto file = tree.open(entry);
    const std::string head = file ? file->text(260) : std::string();
    const auto length = head.size() > 5 ? static_cast<std::uint8_t>(head[4]) : 0u;
    if (length > 0 && 5 + length <= head.size()) return project.page.toUtf8(head.substr(5, length));
    const std::string_view name = archive::nameOf(entry.path);
    return std::string(name.substr(0, name.size() - 4));
  }
  const std::string_view name = archive::nameOf(project.folder);
  return name.empty() ? "project" : std::string(name);
}

bool hasFile(const archive::Tree& tree, const std::string& folder, const std::string& file) {
  return tree.find(folder + "/" + file) != nullptr;
}

void resolve(const archive::Tree& tree, const Project& project, const Links& links,
             Program& program) {
  const auto take = [&](const std::optional<std::uint32_t>& id, const std::string& pattern,
                        const std::string& file, std::string& to) {
    if (!id) return;
    const std::string folder = under(project.folder, fmt::format(fmt::runtime(pattern), *id));
    if (hasFile(tree, folder, file)) to = folder;
  };
  std::string blocks;
  take(links.blocks, "ombstx/offline/{:08x}", "subblk.dbf", blocks);
  if (!blocks.empty()) program.blocks = blocks;
  take(links.symbols, "ydbs/{}", "symlist.dbf", program.symbols);
  take(links.sources, "s7asrcom/{:08x}", "s7contai.dbf", program.sources);
}

// The links back from symbols and sources to the program (SOT, SOI to TOT, TOI).
constexpr std::uint32_t kS7Program = 0x144101;

std::optional<std::uint32_t> backLink(const archive::Tree& tree, const std::string& path,
                                      std::uint32_t sourceType, std::uint32_t relation,
                                      std::uint32_t program) {
  if (tree.find(path) == nullptr) return std::nullopt;
  Table table(tree.open(path));
  while (table.next())
    if (table.numberOr("SOT", 0) == sourceType && table.numberOr("TOT", 0) == kS7Program &&
        table.numberOr("TOI", 0) == program && table.numberOr("RID", 0) == relation)
      return table.number("SOI");
  return std::nullopt;
}

Links backLinks(const archive::Tree& tree, const Project& project, std::uint32_t program) {
  Links links;
  links.symbols = backLink(tree, under(project.folder, "ydbs/ylnklist.dbf"), 0x113001, 25, program);
  for (const auto& entry : tree.below(under(project.folder, "s7asrcom")))
    if (folded(entry.path).ends_with("/s7links.dbf") && !links.sources)
      links.sources = backLink(tree, entry.path, 0x112004, 99, program);
  return links;
}

void readPrograms(const archive::Tree& tree, Project& project, Faults& faults) {
  const std::string path = under(project.folder, "hrs/s7resoff.dbf");
  if (tree.find(path) == nullptr) return;
  Table table = openTable(tree, path, faults);
  const auto linkFile = tree.open(under(project.folder, "hrs/linkhrs.lnk"));
  const Stations stations(tree, project.folder, project.page);
  while (table.next()) {
    Program program;
    program.name = project.page.toUtf8(table.text("NAME"));
    auto links = linkFile ? readLinks(*linkFile, table.numberOr("RSRVD4_L", 0)) : std::nullopt;
    if (!links) {
      faults.push_back({FaultKind::NoLinks, path, program.name});
      links = backLinks(tree, project, table.numberOr("ID", 0));
    }
    resolve(tree, project, *links, program);
    if (links->moduleType && links->module)
      stations.fill(*links->moduleType, *links->module, program);
    project.programs.push_back(std::move(program));
  }
}

bool hasBlocks(const archive::Tree& tree, const std::string& folder) {
  Table table(tree.open(under(folder, "subblk.dbf")));
  return table.next() || table.missingRows() > 0;
}

void addOtherFolders(const archive::Tree& tree, const std::vector<std::string>& folders,
                     Project& project) {
  std::set<std::string> taken;
  for (const Program& program : project.programs)
    if (program.blocks) taken.insert(folded(*program.blocks));
  std::vector<std::string> others;
  for (const std::string& folder : folders)
    if (!taken.contains(folded(folder)) && hasBlocks(tree, folder)) others.push_back(folder);
  // The only folder of the only program whose links are lost.
  if (others.size() == 1 && project.programs.size() == 1 && !project.programs[0].blocks) {
    project.programs[0].blocks = others[0];
    return;
  }
  for (const std::string& folder : others) {
    Program program;
    program.name = folder.empty() ? "blocks" : std::string(archive::nameOf(folder));
    program.blocks = folder;
    project.programs.push_back(std::move(program));
  }
}

}  // namespace

std::string under(const std::string& folder, const std::string& path) {
  return folder.empty() ? path : folder + "/" + path;
}

std::vector<Project> findProjects(const archive::Tree& tree, Faults& faults, unsigned page) {
  // Project folder to its block folders, in the order of the tree.
  std::vector<std::pair<std::string, std::vector<std::string>>> found;
  const auto at = [&](const std::string& folder) -> std::vector<std::string>& {
    for (auto& [known, blocks] : found)
      if (folded(known) == folded(folder)) return blocks;
    return found.emplace_back(folder, std::vector<std::string>()).second;
  };
  for (const auto& entry : tree.files()) {
    if (const auto folder = before(entry.path, "hrs/s7resoff.dbf")) at(*folder);
    const std::string_view name = archive::nameOf(entry.path);
    if (folded(name) != "subblk.dbf") continue;
    const std::string folder(archive::folderOf(entry.path));
    at(projectOfBlocks(folder).value_or(folder)).push_back(folder);
  }
  std::vector<Project> projects;
  for (const auto& [folder, blocks] : found) {
    Project project;
    project.folder = folder;
    readLanguage(tree, project);
    if (page != 0) project.page = CodePage(page), project.pageKnown = true;
    project.name = projectName(tree, project);
    readPrograms(tree, project, faults);
    addOtherFolders(tree, blocks, project);
    if (!project.pageKnown) faults.push_back({FaultKind::UnknownPage, folder, project.name});
    if (project.page.isWide())
      faults.push_back({FaultKind::WidePage, folder, std::to_string(project.page.number())});
    projects.push_back(std::move(project));
  }
  return projects;
}

}  // namespace merker::s7p
