// merker disassemble --mc7 [FILE]
#include <CLI/CLI.hpp>
#include <charconv>
#include <iostream>

#include "block/container.h"
#include "command.h"
#include "input.h"
#include "mc5/disassembly.h"
#include "mc7/disassembly.h"
#include "output.h"

namespace merker::app {
namespace {

struct DisassembleOptions {
  std::string file, mnemonics = "de";
  bool mc5 = false, mc7 = false;
};

using Bytes = std::vector<std::uint8_t>;

constexpr std::string_view kSeparators = " \t\r\n,;";

// Digits in pairs; a word may begin with 0x or 16#.
bool appendHex(std::string_view word, Bytes& bytes) {
  for (std::string_view prefix : {"0x", "0X", "16#"})
    if (word.starts_with(prefix)) word.remove_prefix(prefix.size());
  if (word.size() % 2 != 0) return false;
  for (std::size_t i = 0; i < word.size(); i += 2) {
    unsigned value = 0;
    const auto [end, error] = std::from_chars(word.data() + i, word.data() + i + 2, value, 16);
    if (error != std::errc() || end != word.data() + i + 2) return false;
    bytes.push_back(static_cast<std::uint8_t>(value));
  }
  return true;
}

Bytes parseHex(const source::SourceFile& file, Problems& problems) {
  Bytes bytes;
  const std::string_view text = file.text();
  for (std::size_t start = text.find_first_not_of(kSeparators); start < text.size();) {
    const std::size_t end = std::min(text.find_first_of(kSeparators, start), text.size());
    const std::string_view word = text.substr(start, end - start);
    if (!appendHex(word, bytes))
      problems.add(ProblemCode::P0690, file.position(start, word.size()), word.substr(0, 40));
    start = text.find_first_not_of(kSeparators, end);
  }
  return bytes;
}

void showMc5(const Bytes& bytes) {
  std::vector<std::uint16_t> words;
  for (std::size_t i = 0; i < bytes.size(); i += 2)
    words.push_back(
        static_cast<std::uint16_t>(bytes[i] << 8 | (i + 1 < bytes.size() ? bytes[i + 1] : 0)));
  for (const mc5::Line& line : mc5::disassemble(words)) std::cout << mc5::toString(line) << '\n';
}

int show(const Bytes& bytes, const DisassembleOptions& options) {
  if (options.mc5) {
    showMc5(bytes);
    return kGood;
  }
  const auto mnemonics = options.mnemonics == "en" ? Mnemonics::International : Mnemonics::German;
  for (const mc7::Line& line : mc7::disassemble(bytes, mnemonics))
    std::cout << mc7::toString(line) << '\n';
  return kGood;
}

int notRead(const Problem& problem) {
  Problems problems;
  problems.add(problem);
  printProblems(problems, [](const std::string&) { return nullptr; });
  return problem.code == ProblemCode::P0101 ? kUnreadable : kProblems;
}

// A block as it lies on a memory card begins with two bytes that no machine code begins with.
bool isBlock(const Bytes& bytes) {
  return bytes.size() > 2 && bytes[0] == 0x70 && bytes[1] == 0x70;
}

int showBlock(const Bytes& bytes, const DisassembleOptions& options) {
  const auto block = block::readContainer(bytes, Position{options.file, 0, 0, 0});
  return block ? show(block->code, options) : notRead(block.error());
}

int disassembleFile(const DisassembleOptions& options) {
  const auto content = readBytes(options.file);
  if (!content) return notRead(content.error());
  const Bytes bytes(content.value().begin(), content.value().end());
  return !options.mc5 && isBlock(bytes) ? showBlock(bytes, options) : show(bytes, options);
}

int disassembleInput(const DisassembleOptions& options) {
  auto text = readStandardInput();
  if (!text) return notRead(text.error());
  const source::SourceFile file("standard input", std::move(*text));
  Problems problems;
  const Bytes bytes = parseHex(file, problems);
  printProblems(problems, [&](const std::string&) { return &file; });
  return problems.empty() ? show(bytes, options) : kProblems;
}

int disassemble(const DisassembleOptions& options) {
  if (!options.mc5 && !options.mc7) {
    std::cerr << "merker disassemble: which machine code? Use --mc5 or --mc7\n";
    return kUsage;
  }
  return options.file.empty() || options.file == "-" ? disassembleInput(options)
                                                     : disassembleFile(options);
}

}  // namespace

void addDisassemble(CLI::App& program, int& result) {
  auto* command = program.add_subcommand("disassemble", "machine code to instructions, one a line");
  auto options = std::make_shared<DisassembleOptions>();
  auto* mc7 = command->add_flag("--mc7", options->mc7, "machine code of STEP 7");
  command->add_flag("--mc5", options->mc5, "machine code of STEP 5")->excludes(mc7);
  command->add_option("FILE", options->file,
                      "binary file: machine code or, for STEP 7, a block of a memory card; "
                      "without it, hexadecimal text on standard input");
  command->add_option("--mnemonics", options->mnemonics, "de or en")
      ->check(CLI::IsMember({"de", "en"}));
  command->footer(
      "Examples:\n  echo 'C000 D880 6500' | merker disassemble --mc7\n"
      "  merker disassemble --mc7 code.bin --mnemonics en");
  command->callback([options, &result] { result = disassemble(*options); });
}

}  // namespace merker::app
