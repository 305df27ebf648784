#include "exporting/step7.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "base/code_page.h"
#include "base/text.h"
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

bool mixesMnemonics(const step7::Compilation& compiled) {
  const auto& list = compiled.problems.list();
  return std::any_of(list.begin(), list.end(), [](const Problem& problem) {
    return problem.code == ProblemCode::P0355 || problem.code == ProblemCode::P0356;
  });
}

// Whether the source gives every block of the program again, with the same bytes.
// Blocks without source are called by the names that they have in their containers, or in the
// project.
bool compilesTo(const compilation::Build& build, const std::string& text, bool oneSetting,
                bool byContainers) {
  block::Program callable = *build.library;
  for (const project::MachineCode& file : build.project.machineCode)
    callable.insert_or_assign(file.block.id,
                              byContainers ? file.block : build.program->at(file.block.id));
  step7::CompileOptions options;
  options.model = build.project.model;
  options.library = &callable;
  options.symbols = &build.project.symbols;
  options.mnemonics = build.project.mnemonics;
  const auto compiled = step7::compile({source::SourceFile("export", text)}, options);
  return compiled.ok() && !(oneSetting && mixesMnemonics(compiled)) &&
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

// A way to write the program, and what to say if it is this one.
struct Attempt {
  Style style;
  bool oneSetting = false;  // STEP 7 compiles a source in one setting of mnemonics
  std::string_view warning;
};

// What the parameters of blocks without source are called in their containers.
ParameterNames namesInContainers(const compilation::Build& build) {
  ParameterNames names;
  for (const project::MachineCode& file : build.project.machineCode) {
    const auto here = block::parameters(build.program->at(file.block.id));
    const auto there = block::parameters(file.block);
    if (here.size() != there.size() || file.block.id.kind == BlockKind::DB) continue;
    for (std::size_t i = 0; i < here.size(); ++i)
      if (here[i]->name != there[i]->name)
        names[file.block.id].emplace(upper(here[i]->name), there[i]->name);
  }
  return names;
}

// Most wanted first; what gives other bytes is not written.
std::vector<Attempt> attempts(const project::Project& project, const Options& options) {
  const Names wanted = options.symbols ? Names::Symbolic : Names::Absolute;
  return {
      {{wanted, true}, true, ""},
      {{wanted, true, mnemonicsOf(project)},
       true,
       "warning: the sources use both mnemonics; all of them are written in international ones"},
      {{wanted, true},
       false,
       "warning: the source uses both mnemonics; STEP 7 reads one of them in a source"},
      {{Names::AsWritten, true},
       false,
       "warning: with other names of operands the blocks would get other bytes; the names stay "
       "as they stand in the sources"},
      {{Names::AsWritten, false},
       false,
       "warning: statements stay as they stand in the sources; STEP 7 may miss semicolons"}};
}

std::string textOf(const compilation::Build& build, const Style& style) {
  std::vector<Piece> all = pieces(build.project, style);
  std::erase_if(all, [&](const Piece& piece) { return isMachineCode(build, piece.id); });
  return joined(ordered(std::move(all)));
}

constexpr std::string_view kRenamed =
    "warning: machine code does not have the names of parameters; calls of these blocks use IN0, "
    "OUT0 ... in the source, as STEP 7 shows them";
constexpr std::string_view kOtherNames =
    "warning: the source names variables of blocks that it does not have; machine code does not "
    "have the names: it does not compile with the .wld alone";

// Nothing if no source gives the same blocks.
std::optional<std::string> sourceOf(const compilation::Build& build, const Options& options,
                                    Output& output) {
  const ParameterNames names = namesInContainers(build);
  for (const bool byContainers : {true, false}) {
    for (Attempt attempt : attempts(build.project, options)) {
      if (byContainers) attempt.style.parameters = names;
      std::string text = textOf(build, attempt.style);
      if (!compilesTo(build, text, attempt.oneSetting, byContainers)) continue;
      if (!attempt.warning.empty()) output.warnings.emplace_back(attempt.warning);
      if (!byContainers) output.warnings.emplace_back(kOtherNames);
      if (byContainers && !names.empty()) output.warnings.emplace_back(kRenamed);
      return text;
    }
    if (build.project.machineCode.empty()) break;
  }
  output.warnings.emplace_back("error: no source gives the same blocks again; export .wld");
  return std::nullopt;
}

std::string containers(const block::Program& program, Output& output) {
  std::string bytes;
  for (const auto& [id, block] : program) {
    const std::vector<std::uint8_t> container = block::writeContainer(block);
    bytes.append(container.begin(), container.end());
    if (container.empty() && id.kind != BlockKind::UDT)
      output.warnings.push_back(
          fmt::format("warning: {} is left out: it is too long for a container", toString(id)));
  }
  return bytes;
}

// What no source can give.
void writeMachineCode(const compilation::Build& build, const std::string& path, Output& output) {
  block::Program blocks;
  for (const project::MachineCode& file : build.project.machineCode) {
    const BlockId id = file.block.id;
    blocks.insert_or_assign(id, build.program->at(id));
    output.warnings.push_back(
        fmt::format("{}: warning: {} has machine code and no source: it is in {}", file.file,
                    toString(id), path));
  }
  if (!blocks.empty()) output.files.push_back({path, containers(blocks, output)});
}

std::string symbolBytes(const compilation::Build& build, std::string_view extension,
                        unsigned page) {
  return Encoder(page).encode(
      source::symbolText(build.project.symbols, extension, mnemonicsOf(build.project)));
}

unsigned chosenPage(const compilation::Build& build, const Options& options) {
  return options.page != 0 ? options.page : pageOf(build.project);
}

// What the characters become; the user must choose the language of STEP 7 by it.
std::vector<std::string> aboutCharacters(const compilation::Build& build, const std::string& path,
                                         unsigned page) {
  std::vector<std::string> lines = missingIn(page, build.project);
  if (page != 1252) lines.push_back(fmt::format("{}: texts are in code page {}", path, page));
  return lines;
}

}  // namespace

Output writeAwl(const compilation::Build& build, const std::string& path, const Options& options) {
  Output output;
  const unsigned page = chosenPage(build, options);
  output.warnings = aboutCharacters(build, path, page);
  const auto text = sourceOf(build, options, output);
  if (!text) return output;
  if (!text->empty()) output.files.push_back({path, Encoder(page).encode(withCrLf(*text))});
  if (!output.files.empty() && !build.project.symbols.list().empty())
    output.files.push_back(
        {fs::path(path).replace_extension(".sdf").string(), symbolBytes(build, ".sdf", page)});
  writeMachineCode(build, fs::path(path).replace_extension(".wld").string(), output);
  return output;
}

Output writeWld(const compilation::Build& build, const std::string& path, const Options&) {
  Output output;
  std::string bytes = containers(*build.program, output);
  if (!bytes.empty()) output.files.push_back({path, std::move(bytes)});
  return output;
}

namespace {

// .seq is of STEP 5: it has no column for types. Those of addresses follow from these, those of
// data blocks do not.
void nameLostTypes(const compilation::Build& build, const std::string& path, Output& output) {
  if (source::extensionOf(path) != ".seq") return;
  for (const source::Symbol& symbol : build.project.symbols.list())
    if (symbol.blockType && *symbol.blockType != symbol.address.block)
      output.warnings.push_back(
          fmt::format("{}: warning: the type of {} ({}) is lost: .seq has no types; .sdf keeps it",
                      path, symbol.name, toString(*symbol.blockType)));
}

}  // namespace

Output writeSymbolTable(const compilation::Build& build, const std::string& path,
                        const Options& options) {
  if (build.project.symbols.list().empty()) return {};
  Output output;
  const unsigned page = chosenPage(build, options);
  output.warnings = aboutCharacters(build, path, page);
  nameLostTypes(build, path, output);
  output.files.push_back({path, symbolBytes(build, source::extensionOf(path), page)});
  return output;
}

}  // namespace merker::exporting
