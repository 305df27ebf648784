#include "importing/step5_material.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <span>

#include "s5project/project.h"

namespace merker::importing {
namespace {

constexpr std::size_t kRecord = 128, kLargestProgram = 65535 * kRecord;
constexpr std::size_t kLargestList = 4u << 20;

std::span<const std::uint8_t> bytesOf(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

// A name in the first record; of files of any name without it not more is read.
bool hasName(const archive::File& file) {
  constexpr std::size_t kName = 8, kEnd = 16;
  const std::string head = file.text(kRecord);
  return std::all_of(head.begin() + kName, head.begin() + kEnd,
                     [](char c) { return c >= ' ' && c <= '~'; });
}

struct Neighbours {
  std::optional<std::string> assignments;
  std::vector<std::string> names;
};

using Entries = std::vector<archive::Tree::Entry>;

Entries besideInTree(const archive::Tree& tree, const archive::Tree::Entry& program) {
  Entries list;
  const std::string_view folder = archive::folderOf(program.path);
  for (const archive::Tree::Entry& entry : tree.below(folder))
    if (archive::folderOf(entry.path) == folder) list.push_back(entry);
  return list;
}

// Of a tree that is the program alone: the files of its folder, without links as in a tree.
Entries besideOnDisk(const std::string& source, const archive::Tree::Entry& program) {
  namespace fs = std::filesystem;
  Entries list;
  std::error_code error;
  const fs::path folder = fs::path(source).parent_path();
  fs::directory_iterator at(folder.empty() ? fs::path(".") : folder, error);
  for (std::size_t seen = 0; !error && at != fs::directory_iterator(); at.increment(error)) {
    if (++seen > archive::Limits{}.entries) break;
    std::error_code ignored;
    if (!at->is_symlink(ignored) && at->is_regular_file(ignored))
      list.push_back({at->path().filename().string(), 0, program.in, 0});
  }
  std::ranges::sort(list, {}, &archive::Tree::Entry::path);
  return list;
}

Neighbours neighboursOf(const archive::Tree& tree, const std::string& source,
                        const archive::Tree::Entry& program) {
  Neighbours result;
  for (const archive::Tree::Entry& entry :
       tree.isSingleFile() ? besideOnDisk(source, program) : besideInTree(tree, program)) {
    const std::string name(archive::nameOf(entry.path));
    result.names.push_back(name);
    if (result.assignments || !s5project::isAssignmentList(name, archive::nameOf(program.path)))
      continue;
    if (const auto file = tree.open(entry)) result.assignments = file->text(kLargestList);
  }
  return result;
}

}  // namespace

std::vector<Step5Program> step5Programs(const archive::Tree& tree, bool anyName) {
  std::vector<Step5Program> list;
  for (const archive::Tree::Entry& entry : tree.files()) {
    const bool named = archive::folded(entry.path).ends_with(".s5d");
    const bool maybe = anyName && entry.size % kRecord == 0;
    if ((!named && !maybe) || entry.size > kLargestProgram || entry.size < 2 * kRecord) continue;
    const auto file = tree.open(entry);
    if (!file || (!named && !hasName(*file))) continue;
    if (s5project::recognises(bytesOf(file->text(kLargestProgram))))
      list.push_back({s5project::projectName(archive::nameOf(entry.path)), &entry});
  }
  return list;
}

bool writeStep5Project(const archive::Tree& tree, const std::string& source,
                       const Step5Program& program, Encoding codePage, Output& output,
                       Report& report) {
  const auto file = tree.open(*program.file);
  if (!file) return false;
  const std::string bytes = file->text(kLargestProgram);
  Neighbours beside = neighboursOf(tree, source, *program.file);
  s5project::Input input;
  input.name = archive::nameOf(program.file->path);
  input.program = bytesOf(bytes);
  input.assignments = std::move(beside.assignments);
  input.beside = std::move(beside.names);
  input.codePage = codePage;
  const s5project::Output made = s5project::makeProject(input);
  report.add(Note::CodePage, codePage == Encoding::Cp850 ? 850 : 437);
  report.add(Note::Step5Blocks, made.blocks, made.comments);
  if (made.symbols > 0) report.add(Note::Symbols, made.symbols);
  for (const s5project::Note& note : made.notes)
    report.add(note.lost ? Note::Step5Lost : Note::Step5Changed, note.text);
  for (const s5project::OutputFile& one : made.files) output.write(one.path, one.text);
  return made.usable();
}

}  // namespace merker::importing
