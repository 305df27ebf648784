// merker assemble --mc7 [FILE]
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "base/text.h"
#include "command.h"
#include "input.h"
#include "output.h"
#include "step5/compiler.h"
#include "step5/variable.h"
#include "step7/compiler.h"

namespace merker::app {
namespace {

struct AssembleOptions {
  std::string file, mnemonics;
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

// "0000: C000          U     E 0.0" as `merker disassemble` writes it: the instruction.
std::string_view withoutAddress(std::string_view line) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  const std::size_t colon = line.find_first_not_of(kHex);
  if (colon < 4 || colon >= line.size() || line[colon] != ':') return line;
  std::string_view rest = trim(line.substr(colon + 1));
  bool code = false;  // no mnemonic has four hexadecimal digits
  for (std::size_t end = rest.find_first_not_of(kHex);
       end >= 4 && end != rest.npos && rest[end] == ' '; end = rest.find_first_not_of(kHex)) {
    rest = trim(rest.substr(end));
    code = true;
  }
  return code ? rest : line;
}

// "0000: 7007             illegal": the words of the line, whatever they are.
std::optional<std::string> illegalWords(std::string_view line) {
  constexpr std::string_view kIllegal = "illegal";
  if (!line.ends_with(kIllegal)) return std::nullopt;
  line.remove_suffix(kIllegal.size());
  const std::string_view code = trim(line.substr(std::min(line.find(':') + 1, line.size())));
  const bool hex = code.find_first_not_of("0123456789ABCDEF ") == code.npos && code.size() >= 2;
  return hex ? std::optional(std::string(code)) : std::nullopt;
}

using Setting = std::optional<Mnemonics>;

Setting setting(const AssembleOptions& options) {
  if (options.mnemonics.empty()) return std::nullopt;
  return options.mnemonics == "en" ? Mnemonics::International : Mnemonics::German;
}

// The words of one instruction, or its problem.
Result<std::string> mc7Words(std::string_view line, const Position& at, Setting setting) {
  if (const auto entry = step7::parseListEntry(line, at)) {
    if (!*entry) return entry->error();
    return fmt::format("{:04X} {:04X}", entry->value() >> 16, entry->value() & 0xFFFF);
  }
  auto instruction = step7::parseInstruction(line, at, setting);
  if (!instruction) return instruction.error();
  std::vector<std::uint8_t> code;
  if (!mc7::encode(instruction.value(), code)) return makeProblem(ProblemCode::P0691, at, line);
  return words(code);
}

Result<std::string> mc5Words(std::string_view line, const Position& at) {
  if (const auto parameter = step5::parseConstant(line); parameter && parameter->value <= 0xFFFF)
    return fmt::format("{:04X}", parameter->value);  // behind a call of an FB
  const auto instruction = step5::parseInstruction(line, at);
  if (!instruction) return instruction.error();
  std::vector<std::uint16_t> code;
  if (!mc5::encode(instruction.value(), code)) return makeProblem(ProblemCode::P0691, at, line);
  std::string text;
  for (const std::uint16_t word : code)
    text += fmt::format("{}{:04X}", text.empty() ? "" : " ", word);
  return text;
}

void assembleLine(const source::SourceFile& file, std::uint32_t number,
                  const AssembleOptions& options, Problems& problems) {
  const std::string_view whole = withoutComment(file.line(number));
  if (const auto code = illegalWords(whole)) {
    std::cout << *code << '\n';
    return;
  }
  const std::string_view line = withoutAddress(whole);
  if (line.empty()) return;
  const auto offset = static_cast<std::size_t>(line.data() - file.text().data());
  const Position at = file.position(offset, line.size());
  const auto code = options.mc5 ? mc5Words(line, at) : mc7Words(line, at, setting(options));
  if (code)
    std::cout << code.value() << '\n';
  else
    problems.add(code.error());
}

int assembleText(const source::SourceFile& file, const AssembleOptions& options) {
  Problems problems;
  for (std::uint32_t line = 1; line <= file.lineCount(); ++line)
    assembleLine(file, line, options, problems);
  std::cout << std::flush;
  printProblems(problems, [&](const std::string&) { return &file; });
  return problems.hasErrors() ? kProblems : kGood;
}

Result<source::SourceFile> readText(const std::string& name) {
  if (!name.empty() && name != "-") return source::readSource(name);
  auto text = readStandardInput();
  if (!text) return text.error();
  return source::SourceFile("standard input", std::move(*text));
}

int assemble(const AssembleOptions& options) {
  if (!options.mc5 && !options.mc7) {
    std::cerr << "merker assemble: which machine code? Use --mc5 or --mc7\n";
    return kUsage;
  }
  const auto file = readText(options.file);
  if (file) return assembleText(file.value(), options);
  Problems problems;
  problems.add(file.error());
  printProblems(problems, [](const std::string&) { return nullptr; });
  return file.error().code == ProblemCode::P0101 ? kUnreadable : kProblems;
}

}  // namespace

void addAssemble(CLI::App& program, int& result) {
  auto* command = program.add_subcommand(
      "assemble", "instructions, one a line, to machine code in hexadecimal words");
  auto options = std::make_shared<AssembleOptions>();
  auto* mc7 = command->add_flag("--mc7", options->mc7, "machine code of STEP 7");
  command->add_flag("--mc5", options->mc5, "machine code of STEP 5")->excludes(mc7);
  command->add_option("FILE", options->file, "text file; without it, standard input");
  command
      ->add_option("--mnemonics", options->mnemonics,
                   "de or en; without it, both are accepted and SE is the German one")
      ->check(CLI::IsMember({"de", "en"}));
  command->footer(
      "Jumps are written with their distance in words: SPA 5. What disassemble writes is taken "
      "too.\n"
      "Examples:\n  echo 'U E 0.0' | merker assemble --mc7\n"
      "  echo 'P D 205.10' | merker assemble --mc5");
  command->callback([options, &result] { result = assemble(*options); });
}

}  // namespace merker::app
