#include "exporting/step5.h"

#include <filesystem>

#include "s5d/program.h"
#include "source/dos_text.h"
#include "step5/compiler.h"

namespace merker::exporting {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kProgramEnd = "ST";  // of the stem: xxxxxxST.S5D

// xxxxxx of xxxxxxST.S5D, else the whole stem.
std::string projectOf(const fs::path& path) {
  std::string stem = path.stem().string();
  const std::size_t end = stem.size() - std::min(stem.size(), kProgramEnd.size());
  if (end > 0 && equalsIgnoreCase(stem.substr(end), kProgramEnd)) stem.resize(end);
  return stem;
}

std::string assignments(const compilation::Build& build, Encoding codePage) {
  const source::SymbolTable& symbols = build.project.symbols;
  const std::string text = source::writeSymbols(symbols, ".seq", Mnemonics::German);
  return codePage == Encoding::Cp437 ? text
                                     : source::toDos(toUtf8(text, Encoding::Cp437), codePage);
}

}  // namespace

Output writeS5d(const compilation::Build& build, const std::string& path, const Options& options) {
  const std::vector<std::uint8_t> bytes = s5d::writeProgram(
      build.listings, projectOf(path) + std::string(kProgramEnd), options.codePage);
  std::vector<OutputFile> files{{path, std::string(bytes.begin(), bytes.end())}};
  if (build.project.symbols.list().empty()) return {std::move(files), {}};
  const fs::path list = fs::path(path).parent_path() / (projectOf(path) + "Z0.SEQ");
  files.push_back({list.string(), assignments(build, options.codePage)});
  return {std::move(files), {}};
}

Output writeListing(const compilation::Build& build, const std::string& path,
                    const Options& options) {
  const source::SymbolTable& symbols = build.project.symbols;
  const bool named = options.symbols && !symbols.list().empty();
  std::vector<OutputFile> files{{path, step5::listing(build.listings, named ? &symbols : nullptr)}};
  if (named) {
    const fs::path file(path);
    const fs::path list = file.parent_path() / (file.stem().string() + "Z0.SEQ");
    files.push_back({list.string(), assignments(build, options.codePage)});
  }
  return {std::move(files), {}};
}

Output writeAssignmentList(const compilation::Build& build, const std::string& path,
                           const Options& options) {
  if (build.project.symbols.list().empty()) return {};
  return {{{path, assignments(build, options.codePage)}}, {}};
}

}  // namespace merker::exporting
