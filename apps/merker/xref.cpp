// merker xref PATH: where the program uses what.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "build.h"
#include "command.h"
#include "cpu_option.h"
#include "monitor/assignment_list.h"
#include "monitor/cross_reference.h"
#include "monitor_text.h"

namespace merker::app {
namespace {

struct XrefOptions {
  ProjectOptions project;
  std::string path, operand, mnemonics = "de";
  bool assignment = false, unused = false, json = false;
};

using monitor::AssignmentByte;
using monitor::CrossReference;

std::string_view letter(Area area, Mnemonics mnemonics) {
  const bool german = mnemonics == Mnemonics::German;
  if (area == Area::Input) return german ? "E" : "I";
  if (area == Area::Output) return german ? "A" : "Q";
  return "M";
}

void printReferences(const std::vector<CrossReference>& list) {
  std::size_t width = 14;
  for (const CrossReference& row : list) width = std::max(width, row.operand.size());
  std::cout << fmt::format("{:<{}} {:<24} {:<3} {:<8} {:>3} {:>4}  {:<20} {}\n", "operand", width,
                           "symbol", "use", "block", "NW", "inst", "instruction", "line");
  const CrossReference* last = nullptr;
  for (const CrossReference& row : list) {
    const bool again = last != nullptr && row.operand == last->operand && row.block == last->block;
    last = &row;
    std::cout << fmt::format("{:<{}} {:<24} {:<3} {:<8} {:>3} {:>4}  {:<20} {}:{}\n",
                             again ? "" : row.operand, width, again ? "" : row.symbol,
                             monitor::name(row.use), toString(row.place.block), row.place.network,
                             row.statement, row.instruction, row.place.file, row.place.line);
  }
}

nlohmann::ordered_json json(const std::vector<CrossReference>& list) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const CrossReference& row : list)
    rows.push_back({{"operand", row.operand},
                    {"symbol", row.symbol},
                    {"use", monitor::name(row.use)},
                    {"place", app::toJson(row.place)},
                    {"statement", row.statement},
                    {"instruction", row.instruction}});
  return rows;
}

std::string numbers(const std::vector<std::uint32_t>& list) {
  std::string text;
  for (const std::uint32_t number : list)
    text += (text.empty() ? "" : " ") + std::to_string(number);
  return text.empty() ? "-" : text;
}

void printAssignment(const monitor::AssignmentList& list, Mnemonics mnemonics) {
  std::cout << "          7 6 5 4 3 2 1 0  B W D\n";
  for (const AssignmentByte& byte : list.bytes) {
    std::string row = fmt::format("{}B {:<6}", letter(byte.area, mnemonics), byte.byte);
    for (unsigned bit = 8; bit-- > 0;) row += byte.bits[bit] ? " X" : " .";
    const auto mark = [](bool used) { return used ? " |" : " ."; };
    std::cout << row << ' ' << mark(byte.byByte) << mark(byte.byWord) << mark(byte.byDWord) << '\n';
  }
  const bool german = mnemonics == Mnemonics::German;
  std::cout << "T " << numbers(list.timers) << '\n'
            << (german ? "Z " : "C ") << numbers(list.counters) << '\n';
}

nlohmann::ordered_json json(const monitor::AssignmentList& list, Mnemonics mnemonics) {
  nlohmann::ordered_json bytes = nlohmann::ordered_json::array();
  for (const AssignmentByte& byte : list.bytes) {
    nlohmann::ordered_json bits = nlohmann::ordered_json::array();
    for (unsigned bit = 0; bit < 8; ++bit)
      if (byte.bits[bit]) bits.push_back(bit);
    bytes.push_back({{"byte", fmt::format("{}B {}", letter(byte.area, mnemonics), byte.byte)},
                     {"bits", bits},
                     {"by_byte", byte.byByte},
                     {"by_word", byte.byWord},
                     {"by_dword", byte.byDWord}});
  }
  return {{"bytes", bytes}, {"timers", list.timers}, {"counters", list.counters}};
}

void printUnused(const std::vector<CrossReference>& list, const source::SymbolTable& symbols) {
  std::cout << "symbols that no instruction uses\n";
  for (const source::Symbol& symbol : monitor::unusedSymbols(list, symbols))
    std::cout << fmt::format("  \"{}\" ({}:{})\n", symbol.name, symbol.position.file,
                             symbol.position.line);
  std::cout << "operands without symbol\n";
  for (const std::string& operand : monitor::operandsWithoutSymbol(list))
    std::cout << "  " << operand << '\n';
}

nlohmann::ordered_json unusedJson(const std::vector<CrossReference>& list,
                                  const source::SymbolTable& symbols) {
  nlohmann::ordered_json names = nlohmann::ordered_json::array();
  for (const source::Symbol& symbol : monitor::unusedSymbols(list, symbols))
    names.push_back(symbol.name);
  return {{"unused_symbols", names},
          {"operands_without_symbol", monitor::operandsWithoutSymbol(list)}};
}

void print(const nlohmann::ordered_json& document) {
  std::cout << document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

std::vector<CrossReference> references(const Build& built, Mnemonics mnemonics) {
  return monitor::crossReferences(built.code(), built.project.symbols,
                                  {.mnemonics = mnemonics, .library = built.library.get()});
}

int show(const XrefOptions& options, const Build& built) {
  const Mnemonics mnemonics = options.mnemonics == "en" && !built.isListing()
                                  ? Mnemonics::International
                                  : Mnemonics::German;
  const source::SymbolTable& symbols = built.project.symbols;
  auto list = references(built, mnemonics);
  if (!options.operand.empty()) {
    auto part = monitor::filtered(list, options.operand, built.resolver(),
                                  monitor::filterWords(built.code()), symbols);
    if (!part) {
      std::cerr << "merker xref: --operand: " << part.error().message << '\n';
      return kUsage;
    }
    list = std::move(part.value());
  }
  if (options.assignment) {
    const auto assignment = monitor::assignmentList(list);
    options.json ? print(json(assignment, mnemonics)) : printAssignment(assignment, mnemonics);
  } else if (options.unused) {
    options.json ? print(unusedJson(list, symbols)) : printUnused(list, symbols);
  } else {
    options.json ? print({{"references", json(list)}}) : printReferences(list);
  }
  return exitCode(built);
}

int xref(const XrefOptions& options) {
  const Build built = build(loadProject(options.path, options.project), false);
  if (!built.ok()) return report(built, options.json);
  printProblems(built.problems, built.files());
  return show(options, built);
}

}  // namespace

void addXref(CLI::App& program, int& result) {
  auto* command = program.add_subcommand(
      "xref", "cross reference: where each operand is read, written or called");
  auto options = std::make_shared<XrefOptions>();
  command->add_option("PATH", options->path, "project folder or source")->required();
  command->add_option(
      "--operand", options->operand,
      "only these: \"M 10.0, MW 20\", \"DB 1\", E, T, \"\\\"Motor\\\"\", STEP 5 =EIN; overlapping "
      "accesses count");
  auto* assignment = command->add_flag("--assignment", options->assignment,
                                       "used bits of E, A, M; timers and counters");
  command
      ->add_flag("--unused", options->unused, "symbols that nothing uses, operands without symbol")
      ->excludes(assignment);
  command->add_option("--mnemonics", options->mnemonics, "de or en; STEP 5 has German ones")
      ->check(CLI::IsMember({"de", "en"}));
  addProjectOptions(*command, options->project);
  command->add_flag("--json", options->json, "as one JSON object");
  command->footer(
      "Columns: R read, W written, RW both, - called or opened; NW and inst count from 1.\n"
      "Examples:\n"
      "  merker xref examples/sorting-plant --operand A\n"
      "  merker xref plant.awl --assignment\n"
      "  merker xref press.s5 --operand \"DW 5\"");
  command->callback([options, &result] { result = xref(*options); });
}

}  // namespace merker::app
