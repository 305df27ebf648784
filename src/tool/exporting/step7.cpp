#include "exporting/step7.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "block/container.h"
#include "exporting/awl_source.h"
#include "exporting/characters.h"
#include "source/symbol_text.h"
#include "step7/compiler.h"

namespace merker::exporting {
namespace {

namespace fs = std::filesystem;

bool isMachineCode(const compilation::Build& build, BlockId id) {
  const auto& code = build.project.machineCode;
  return std::any_of(code.begin(), code.end(),
                     [id](const project::MachineCode& file) { return file.block.id == id; });
}

// A piece must not end within a line.
std::string joined(const std::vector<Piece>& pieces) {
  std::string text;
  for (const Piece& piece : pieces) {
    text += piece.text;
    if (!text.ends_with('\n')) text += '\n';
  }
  return text;
}

// Whether the source gives every block of the program again, with the same bytes.
bool compilesTo(const compilation::Build& build, const std::string& text) {
  block::Program callable = *build.library;
  for (const project::MachineCode& file : build.project.machineCode)
    callable.insert_or_assign(file.block.id, build.program->at(file.block.id));
  step7::CompileOptions options;
  options.model = build.project.model;
  options.library = &callable;
  options.symbols = &build.project.symbols;
  options.mnemonics = build.project.mnemonics;
  const auto compiled = step7::compile({source::SourceFile("export", text)}, options);
  return compiled.ok() &&
         std::all_of(build.program->begin(), build.program->end(), [&](const auto& entry) {
           if (isMachineCode(build, entry.first)) return true;
           const auto found = compiled.program.find(entry.first);
           return found != compiled.program.end() &&
                  block::writeContainer(found->second) == block::writeContainer(entry.second);
         });
}

std::string withCrLf(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\n') out += '\r';
    out += c;
  }
  return out;
}

// Most wanted first; what gives other bytes is not written.
std::vector<Style> stylesOf(const Options& options) {
  const Names wanted = options.symbols ? Names::Symbolic : Names::Absolute;
  return {{wanted, true}, {Names::AsWritten, true}, {Names::AsWritten, false}};
}

std::vector<Piece> exportable(const compilation::Build& build, Style style) {
  std::vector<Piece> all = pieces(build.project, style);
  std::erase_if(all, [&](const Piece& piece) { return isMachineCode(build, piece.id); });
  return ordered(std::move(all));
}

std::string sourceOf(const compilation::Build& build, const Options& options, Output& output) {
  for (const Style& style : stylesOf(options)) {
    std::string text = joined(exportable(build, style));
    if (text.empty() || compilesTo(build, text)) return text;
    output.warnings.push_back(
        style.names != Names::AsWritten
            ? "warning: with other names of operands the blocks would get other bytes; the names "
              "are written as they stand in the sources"
        : style.punctuation
            ? "warning: STEP 7 may miss semicolons: the statements are written as they stand in "
              "the sources"
            : "warning: the file does not compile to the same blocks; the sources may use both "
              "German and international mnemonics");
    if (style.names == Names::AsWritten && !style.punctuation) return text;
  }
  return {};
}

void noteMachineCode(const compilation::Build& build, Output& output) {
  for (const project::MachineCode& file : build.project.machineCode)
    output.warnings.push_back(fmt::format(
        "{}: warning: {} is left out: it has machine code and no source; export .wld for it",
        file.file, toString(file.block.id)));
}

std::string symbolBytes(const compilation::Build& build, std::string_view extension) {
  return source::writeSymbols(build.project.symbols, extension, mnemonicsOf(build.project));
}

}  // namespace

Output writeAwl(const compilation::Build& build, const std::string& path, const Options& options) {
  Output output;
  output.warnings = missingInCp1252(build.project);
  noteMachineCode(build, output);
  const std::string text = sourceOf(build, options, output);
  if (text.empty()) return output;
  output.files.push_back({path, toCp1252(withCrLf(text))});
  if (!build.project.symbols.list().empty())
    output.files.push_back(
        {fs::path(path).replace_extension(".sdf").string(), symbolBytes(build, ".sdf")});
  return output;
}

Output writeWld(const compilation::Build& build, const std::string& path, const Options&) {
  Output output;
  std::string bytes;
  for (const auto& [id, block] : *build.program) {
    const std::vector<std::uint8_t> container = block::writeContainer(block);
    bytes.append(container.begin(), container.end());
    if (container.empty() && id.kind != BlockKind::UDT)
      output.warnings.push_back(
          fmt::format("warning: {} is left out: it is too long for a container", toString(id)));
  }
  if (!bytes.empty()) output.files.push_back({path, std::move(bytes)});
  return output;
}

Output writeSymbolTable(const compilation::Build& build, const std::string& path, const Options&) {
  if (build.project.symbols.list().empty()) return {};
  Output output;
  output.warnings = missingInCp1252(build.project);
  output.files.push_back({path, symbolBytes(build, source::extensionOf(path))});
  return output;
}

}  // namespace merker::exporting
