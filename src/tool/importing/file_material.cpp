#include "importing/file_material.h"

#include <algorithm>

#include "base/bytes.h"
#include "block/container.h"
#include "importing/file_text.h"
#include "importing/hardware.h"
#include "importing/output.h"
#include "importing/recognise.h"
#include "project/discovery.h"
#include "project/files.h"
#include "step7/foreign_language.h"

namespace merker::importing {
namespace {

constexpr std::size_t kLargest = source::kLargestSource << 20, kLengthAt = 8, kHeader = 36;

std::string stem(std::string_view path) {
  const std::string_view name = archive::nameOf(path);
  return std::string(name.substr(0, name.rfind('.')));
}

// Containers one behind the other: a block, or a WLD file.
void addContainers(const std::string& path, const std::string& bytes, Material& material,
                   Report& report) {
  std::span rest(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  while (rest.size() > kHeader) {
    auto block = block::readContainer(rest, Position{path});
    const std::size_t length = std::max<std::size_t>(kHeader, loadDWord(&rest[kLengthAt]));
    if (!block)
      report.add(Note::WrongContainer, path, block.error().message);
    else if (std::any_of(material.blocks.begin(), material.blocks.end(),
                         [&](const auto& b) { return b.block.id == block->id; }))
      report.add(Note::TwiceInFolder, toString(block->id));
    else if (block->id.kind != BlockKind::SDB)  // system data: what modules are there
      material.blocks.push_back({std::move(block.value()), {}, {}, false, {}});
    if (length > rest.size()) return;
    rest = rest.subspan(length);
  }
}

void add(const archive::Tree::Entry& entry, const archive::File& file, Kind kind, const Page& page,
         Material& material, Report& report) {
  if (file.size() > kLargest)
    return report.add(Note::LongSource, entry.path, source::kLargestSource);
  const std::string bytes = file.text(kLargest);
  if (kind == Kind::Containers) return addContainers(entry.path, bytes, material, report);
  const auto text = readText(entry.path, bytes, page, report);
  if (!text) return;
  if (kind == Kind::Hardware) return readHardware(*text, material);
  if (const auto foreign = kind == Kind::AwlSource ? step7::foreignText(*text) : std::nullopt) {
    report.add(Note::ForeignFile, entry.path, foreign->language);
    material.foreign.push_back({stem(entry.path), *text, false});
    return;
  }
  material.files.push_back({stem(entry.path) + std::string(extensionOf(kind)), *text,
                            kind == Kind::AwlSource,
                            kind == Kind::Listing || kind == Kind::Assignments});
}

// The page of all files together that are not Unicode.
PageGuess commonPage(const archive::Tree& tree) {
  constexpr std::size_t kOfOne = 64u << 10, kOfAll = 1u << 20;
  std::string all;
  for (const auto& entry : tree.files()) {
    const auto file = all.size() < kOfAll ? tree.open(entry) : nullptr;
    const Kind kind = file ? recognise(*file, entry.path) : Kind::Unknown;
    if (kind == Kind::Unknown || kind == Kind::Containers || kind == Kind::Damaged) continue;
    const std::string head = file->text(kOfOne);
    if (formOf(head).guess.page != 0) all += head + '\n';
  }
  return guessedPage(all);
}

void addOwn(const archive::Tree::Entry& entry, const archive::File& file, const Page& page,
            Material& material, Report& report) {
  if (file.size() > kLargest)
    return report.add(Note::LongSource, entry.path, source::kLargestSource);
  const auto text = readText(entry.path, file.text(kLargest), page, report);
  if (text) material.files.push_back({std::string(archive::nameOf(entry.path)), *text, false});
}

void addFiles(const archive::Tree& tree, unsigned page, Material& material, Report& report) {
  const Page pages{page, page == 0 ? commonPage(tree) : PageGuess{}};
  for (const auto& entry : tree.files()) {
    const auto file = tree.open(entry);
    if (!file) continue;  // the tree says why
    const Kind kind = recognise(*file, entry.path);
    if (kind != Kind::Unknown)
      add(entry, *file, kind, pages, material, report);
    else if (isOwnFile(entry.path, *file))
      addOwn(entry, *file, pages, material, report);
    else
      report.add(Note::UnknownFile, entry.path);
  }
}

// A program is of one family; what is of the other one can be a project of its own.
void chooseFamily(Material& material, Report& report) {
  const auto listed = [](const TextFile& file) { return file.step5; };
  const auto of7 = std::ranges::any_of(material.files, &TextFile::awl) ||
                   !material.blocks.empty() || !material.modules.empty() ||
                   !material.foreign.empty();
  material.step5 = !of7 && std::ranges::any_of(material.files, listed);
  if (material.step5) return;
  for (const TextFile& file : material.files)
    if (file.step5) report.add(Note::OtherFamily, file.name);
  std::erase_if(material.files, listed);
}

// A listing that is a file alone has its symbols where it lies.
void addSymbolsBeside(const std::string& source, unsigned page, Material& material,
                      Report& report) {
  for (const std::string& name : project::symbolsBeside(source)) {
    const archive::Tree symbols(project::join(project::folderOf(source), name));
    if (symbols.isSingleFile()) addFiles(symbols, page, material, report);
  }
}

}  // namespace

Material materialOf(const archive::Tree& tree, const std::string& source, unsigned page,
                    Report& report) {
  Material material;
  material.name = stemOf(source);
  addFiles(tree, page, material, report);
  const bool listing = std::ranges::any_of(
      material.files, [](const TextFile& file) { return file.name.ends_with(".s5"); });
  if (tree.isSingleFile() && listing) addSymbolsBeside(source, page, material, report);
  chooseFamily(material, report);
  return material;
}

}  // namespace merker::importing
