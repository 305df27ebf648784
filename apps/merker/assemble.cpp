// merker assemble --mc7 [FILE]
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "base/text.h"
#include "command.h"
#include "input.h"
#include "output.h"
#include "step7/compiler.h"

namespace merker::app {
namespace {

struct Options {
  std::string file;
  bool mc5 = false, mc7 = false;
};

// "3003 0005"
std::string words(const std::vector<std::uint8_t>& code) {
  std::string text;
  for (std::size_t i = 0; i + 1 < code.size(); i += 2)
    text += fmt::format("{}{:02X}{:02X}", i == 0 ? "" : " ", code[i], code[i + 1]);
  return text;
}

std::string_view withoutComment(std::string_view line) {
  return trim(line.substr(0, line.find("//")));
}

void assembleLine(const source::SourceFile& file, std::uint32_t number, Problems& problems) {
  const std::string_view line = withoutComment(file.line(number));
  if (line.empty()) return;
  const auto offset = static_cast<std::size_t>(line.data() - file.text().data());
  const Position at = file.position(offset, line.size());
  auto instruction = step7::parseInstruction(line, at);
  std::vector<std::uint8_t> code;
  if (!instruction)
    problems.add(instruction.error());
  else if (!mc7::encode(instruction.value(), code))
    problems.add(ProblemCode::P0691, at, line);
  else
    std::cout << words(code) << '\n';
}

int assembleText(const source::SourceFile& file) {
  Problems problems;
  for (std::uint32_t line = 1; line <= file.lineCount(); ++line) assembleLine(file, line, problems);
  std::cout << std::flush;
  printProblems(problems, [&](const std::string&) { return &file; });
  return problems.hasErrors() ? kProblems : kGood;
}

int assemble(const Options& options) {
  if (options.mc5 || !options.mc7) {
    std::cerr << "merker assemble: "
              << (options.mc5 ? "machine code of STEP 5 (--mc5) comes in a later version\n"
                              : "which machine code? Use --mc7\n");
    return kUsage;
  }
  if (options.file.empty() || options.file == "-")
    return assembleText(source::SourceFile("standard input", readStandardInput()));
  const auto file = source::readSource(options.file);
  if (file) return assembleText(file.value());
  Problems problems;
  problems.add(file.error());
  printProblems(problems, [](const std::string&) { return nullptr; });
  return file.error().code == ProblemCode::P0101 ? kUnreadable : kProblems;
}

}  // namespace

void addAssemble(CLI::App& program, int& result) {
  auto* command = program.add_subcommand(
      "assemble", "instructions, one a line, to machine code in hexadecimal words");
  auto options = std::make_shared<Options>();
  auto* mc7 = command->add_flag("--mc7", options->mc7, "machine code of STEP 7");
  command->add_flag("--mc5", options->mc5, "machine code of STEP 5")->excludes(mc7);
  command->add_option("FILE", options->file, "text file; without it, standard input");
  command->footer(
      "Jumps are written with their distance in words: SPA 5.\n"
      "Example:\n  echo 'U E 0.0' | merker assemble --mc7");
  command->callback([options, &result] { result = assemble(*options); });
}

}  // namespace merker::app
