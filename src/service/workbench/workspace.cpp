#include "workbench/workspace.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "base/text.h"
#include "base/utf8.h"
#include "project/files.h"
#include "project/settings.h"
#include "workbench/example_language.h"
#include "workbench/json.h"
#include "workbench/project_folder.h"
#include "workbench/start_declaration.h"

namespace merker::workbench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSettings = "merker.toml";
constexpr Template kTemplates[] = {{"empty", "OB 1"}, {"errors", "OB 1, OB 100, error OBs"}};
constexpr std::uint32_t kErrorBlocks[] = {100, 80, 82, 85, 86, 87, 121, 122};

bool isProject(const fs::path& folder) {
  std::error_code error;
  return fs::is_regular_file(folder / kSettings, error);
}

// Text without its marks: `code`, [link](target).
std::string plain(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ']' && i + 1 < text.size() && text[i + 1] == '(')
      i = std::min(text.find(')', i), text.size());
    else if (text[i] != '`' && text[i] != '[')
      result += text[i];
  }
  if (result.ends_with(':')) result.back() = '.';
  return result;
}

// The first heading of the README and the first sentences below it; no tables, no listings.
void describe(const fs::path& folder, Example& example) {
  std::ifstream file(folder / "README.md");
  std::string line, paragraph;
  bool listing = false;
  while (std::getline(file, line)) {
    const std::string_view text = trim(line);
    const bool fence = text.starts_with("```");
    if (fence) listing = !listing;
    const bool prose = !listing && !fence && !text.empty() && text.front() != '|';
    if (text.starts_with("# ") && example.title.empty())
      example.title = plain(text.substr(2));
    else if (prose)
      paragraph += fmt::format("{}{}", paragraph.empty() ? "" : " ", text);
    else if (!paragraph.empty())
      break;
  }
  example.description = plain(paragraph);
}

void collect(const fs::path& root, const std::string& below, std::vector<Example>& list) {
  for (const project::Entry& entry : project::entries((root / below).string())) {
    if (!entry.folder) continue;
    const std::string id = below.empty() ? entry.name : fmt::format("{}/{}", below, entry.name);
    if (!isProject(root / id)) {
      collect(root, id, list);
      continue;
    }
    Example example{id, {}, {}};
    describe(root / id, example);
    if (example.title.empty()) example.title = entry.name;
    list.push_back(std::move(example));
  }
}

// What is copied for an example, and where the example is in the copy. Stations of a pair name each
// other's folders (technology/two-stations/filling): they come together.
struct Copied {
  std::string from, name, inside;
};

Copied copiedFor(const std::string& id) {
  const std::size_t first = id.find('/'), last = id.rfind('/');
  Copied copied{id, id, {}};
  if (first != last) copied = {id.substr(0, last), id.substr(0, last), id.substr(last + 1)};
  std::ranges::replace(copied.name, '/', '-');
  return copied;
}

// An import of several programs has a folder for each.
void findProjects(const fs::path& root, const std::string& below, int depth,
                  std::vector<std::string>& found) {
  constexpr int kDeepest = 2;
  constexpr std::size_t kMost = 500;
  for (const project::Entry& entry : project::entries((root / below).string())) {
    if (found.size() == kMost) return;
    if (!entry.folder) continue;
    const std::string path = below.empty() ? entry.name : fmt::format("{}/{}", below, entry.name);
    if (!isValidUtf8(path)) continue;
    if (isProject(root / path))
      found.push_back(path);
    else if (depth < kDeepest)
      findProjects(root, path, depth + 1, found);
  }
}

// From Latin-1 on letters, but for signs, spaces that look like none, and what changes direction.
bool isLetter(char32_t c) {
  if (c < 0x80) return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return c >= 0xC0 && c != 0xD7 && c != 0xF7 && (c < 0x2000 || c > 0x2BFF) &&
         (c < 0xD800 || c > 0xF8FF) && c < 0xFE00;
}

bool isNameCharacter(char32_t c) {
  return isLetter(c) || (c >= '0' && c <= '9') || c == ' ' || c == '-' || c == '_';
}

bool isProjectName(std::string_view name) {
  constexpr std::size_t kLongest = 64;
  constexpr std::size_t kLongestName = 200;  // bytes; file systems end at 255
  if (name.empty() || name.size() > kLongestName || trim(name) != name || !isValidUtf8(name) ||
      characterCount(name) > kLongest)
    return false;
  for (std::size_t at = 0; at < name.size();) {
    if (!isNameCharacter(nextCharacter(name, at))) return false;
  }
  return true;
}

bool isBelow(const fs::path& path, const fs::path& folder) {
  const auto [end, unused] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return !folder.empty() && end == folder.end();
}

fs::path canonical(const std::string& path) {
  std::error_code error;
  return path.empty() ? fs::path() : fs::weakly_canonical(path, error);
}

// With its start information. A comment in the words of the mnemonics: an empty network says of
// neither which it is.
std::string blockText(std::uint32_t ob, Mnemonics mnemonics) {
  return fmt::format(
      "ORGANIZATION_BLOCK OB {}\n{}BEGIN\nNETWORK\nTITLE = {}\n\nEND_ORGANIZATION_BLOCK\n\n", ob,
      startDeclaration(ob), mnemonics == Mnemonics::German ? "Netzwerk 1" : "Network 1");
}

// Error OBs as far as the CPU has them.
std::string awlText(const NewProject& wanted, const CpuModel& model) {
  std::string text = blockText(1, wanted.mnemonics);
  if (wanted.ob != 1) text += blockText(wanted.ob, wanted.mnemonics);
  if (wanted.form == "errors")
    for (const std::uint32_t ob : kErrorBlocks)
      if (ob != wanted.ob && model.hasOrganizationBlock(ob))
        text += blockText(ob, wanted.mnemonics);
  return text;
}

std::string settingsText(const NewProject& wanted) {
  return fmt::format("[project]\nname = \"{}\"\n\n[cpu]\nmodel = \"{}\"\n", wanted.name,
                     wanted.model);
}

using Files = std::vector<std::pair<std::string, std::string>>;

Files simaticFiles(const NewProject& wanted, const CpuModel& model) {
  return {{kSettings, settingsText(wanted) + fmt::format("mpi_address = {}\n", wanted.mpiAddress)},
          {"main.awl", awlText(wanted, model)},
          {"symbols.sym", ""}};
}

// STEP 5: OB 1 as a listing, and the assignment list.
Files sinumerikFiles(const NewProject& wanted) {
  return {{kSettings, settingsText(wanted)},
          {"main.s5", "OB 1\nNETZWERK 1\n : BE\n"},
          {"symbols.seq", ""}};
}

// One name for one folder, also where a link leads to it.
std::string realPath(const std::string& path) {
  std::error_code error;
  const fs::path found = path.empty() ? fs::path() : fs::absolute(path, error);
  return error ? path : canonical(found.string()).string();
}

Problem notMade(const std::string& path, const std::error_code& error) {
  return makeProblem(ProblemCode::P1313, nowhere(), path, error.message());
}

}  // namespace

Workspace::Workspace(const std::string& folder, std::string examples, std::string given)
    : folder_(realPath(folder)), examples_(std::move(examples)), given_(std::move(given)) {}

std::vector<Example> Workspace::examples() const {
  std::vector<Example> list;
  if (!examples_.empty()) collect(examples_, "", list);
  for (Example& one : list) {
    const Copied copied = copiedFor(one.id);
    one.copied = isProject(fs::path(folder_) / copied.name / copied.inside);
  }
  return list;
}

std::vector<std::string> Workspace::projects() const {
  std::vector<std::string> found;
  if (!folder_.empty()) findProjects(folder_, "", 0, found);
  return found;
}

std::span<const Template> Workspace::templates() { return kTemplates; }

Result<std::string> Workspace::copyExample(const std::string& id, bool fresh, bool german) const {
  const auto all = examples();
  if (std::ranges::find(all, id, &Example::id) == all.end())
    return makeProblem(ProblemCode::P1316, nowhere(), "example", id, "");
  const Copied copied = copiedFor(id);
  fs::path to = fs::path(folder_) / copied.name;
  const bool there = isProject(to / copied.inside);
  const auto opened = [&] {
    return copied.inside.empty() ? to.string() : (to / copied.inside).string();
  };
  if (there && !fresh) return opened();
  if (there) to = fs::path(folder_) / freeName(copied.name);
  std::error_code error;
  fs::create_directories(to, error);
  if (!error) fs::copy(fs::path(examples_) / copied.from, to, fs::copy_options::recursive, error);
  if (error) return notMade(to.string(), error);
  if (auto problem = finishCopy(to.string(), german)) return *problem;
  return opened();
}

Result<std::string> Workspace::folderToOpen(const std::string& folder) const {
  const bool bad = folder.empty() || folder.find('\0') != std::string::npos;
  const fs::path path =
      canonical(folder == given_ ? given_ : (fs::path(folder_) / folder).string());
  const bool allowed = path == canonical(given_) || isBelow(path, canonical(folder_));
  if (bad || !allowed) return makeProblem(ProblemCode::P1318, nowhere(), folder, folder_);
  // The name that was given, so that places in it are named as ever.
  return path == canonical(given_) ? given_ : path.string();
}

std::vector<std::string> Workspace::named(const std::vector<std::string>& folders) const {
  std::vector<std::string> list;
  for (const std::string& folder : folders) {
    const std::string path = isBelow(canonical(folder), folder_) ? realPath(folder) : folder;
    if (std::ranges::find(list, path) == list.end()) list.push_back(path);
  }
  return list;
}

Result<std::string> Workspace::makeFolder(const std::string& name) const {
  if (!isProjectName(name)) return makeProblem(ProblemCode::P1317, nowhere(), name);
  const fs::path folder = fs::path(folder_) / name;
  std::error_code error;
  fs::create_directories(folder_, error);
  if (fs::create_directory(folder, error)) return folder.string();
  return error ? notMade(folder.string(), error) : makeProblem(ProblemCode::P1312, nowhere(), name);
}

std::string Workspace::freeName(std::string_view wanted) const {
  constexpr std::size_t kLongest = 60;  // bytes, with room for a number
  std::string name;
  for (std::size_t at = 0; at < wanted.size() && name.size() < kLongest;) {
    const char32_t c = nextCharacter(wanted, at);
    appendCharacter(name, isNameCharacter(c) ? c : U'_');
  }
  name = trim(name);
  if (name.empty()) name = "import";
  std::string free = name;
  std::error_code error;
  for (int i = 2; fs::exists(fs::symlink_status(fs::path(folder_) / free, error)); ++i)
    free = fmt::format("{} {}", name, i);
  return free;
}

std::optional<Problem> Workspace::wrong(const NewProject& wanted) {
  const auto model = project::findModel(wanted.model);
  if (!model)
    return makeProblem(ProblemCode::P0705, nowhere(), wanted.model, project::modelNames());
  if (model->simatic != nullptr && !model->simatic->hasOrganizationBlock(wanted.ob))
    return makeProblem(ProblemCode::P0502, nowhere(), fmt::format("OB {}", wanted.ob),
                       model->simatic->name);
  if (std::ranges::find(kTemplates, wanted.form, &Template::id) == std::end(kTemplates))
    return makeProblem(ProblemCode::P1316, nowhere(), "template", wanted.form, "");
  return std::nullopt;
}

std::optional<Problem> Workspace::fill(const std::string& folder, const NewProject& wanted) {
  const ProjectFolder files(folder);
  const project::Model model = *project::findModel(wanted.model);
  for (const auto& [name, text] :
       model.simatic != nullptr ? simaticFiles(wanted, *model.simatic) : sinumerikFiles(wanted))
    if (auto problem = files.create(name, text)) return problem;
  return std::nullopt;
}

Result<std::string> Workspace::make(const NewProject& wanted) const {
  if (!isProjectName(wanted.name)) return makeProblem(ProblemCode::P1317, nowhere(), wanted.name);
  if (auto problem = wrong(wanted)) return *problem;
  const auto folder = makeFolder(wanted.name);
  if (!folder) return folder.error();
  if (auto problem = fill(*folder, wanted)) return *problem;
  return *folder;
}

}  // namespace merker::workbench
