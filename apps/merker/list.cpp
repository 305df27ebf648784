// merker list PATH [--code] [--view kop|fup]
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "build.h"
#include "card.h"
#include "command.h"
#include "cpu_option.h"
#include "list_view.h"
#include "listing_blocks.h"
#include "mc7/disassembly.h"
#include "memory_report.h"
#include "monitor/block_list.h"

namespace merker::app {
namespace {

struct ListOptions {
  ProjectOptions project;
  std::string path, card, mnemonics, view, svg;
  bool code = false, memory = false, listing = false, symbols = false, json = false;
};

Mnemonics mnemonicsOf(const ListOptions& options) {
  return options.mnemonics == "en" ? Mnemonics::International : Mnemonics::German;
}

std::vector<mc7::Line> lines(const block::Block& block, const ListOptions& options) {
  return mc7::disassemble(block.code, mnemonicsOf(options));
}

void printRow(const monitor::BlockRow& r) {
  std::cout << fmt::format("{:<10} {:<24} {:>6} {:>6} {:>6}  {:<7}  {:04X}\n", toString(r.id),
                           r.symbol, r.load, r.work, r.local, r.version, r.checksum);
}

void printTable(const Build& build, const ListOptions& options) {
  std::cout << fmt::format("{:<10} {:<24} {:>6} {:>6} {:>6}  {:<7}  {}\n", "block", "name", "load",
                           "work", "local", "version", "checksum");
  for (const auto& [id, block] : *build.program) {
    printRow(monitor::blockRow(block));
    if (!options.code) continue;
    for (const mc7::Line& line : lines(block, options))
      std::cout << "  " << mc7::toString(line) << '\n';
  }
}

std::string hex(std::span<const std::uint8_t> bytes) {
  std::string text;
  for (std::uint8_t byte : bytes) text += fmt::format("{:02X}", byte);
  return text;
}

nlohmann::json blockToJson(const block::Block& block, const ListOptions& options) {
  const monitor::BlockRow r = monitor::blockRow(block);
  nlohmann::json document = {{"block", toString(r.id)}, {"name", r.symbol},
                             {"load_bytes", r.load},    {"work_bytes", r.work},
                             {"local_bytes", r.local},  {"version", r.version},
                             {"checksum", r.checksum}};
  if (!options.code) return document;
  document["code"] = nlohmann::json::array();
  for (const mc7::Line& line : lines(block, options))
    document["code"].push_back(
        {{"offset", line.offset}, {"bytes", hex(line.bytes)}, {"text", line.text}});
  return document;
}

void printJson(const Build& build, const ListOptions& options) {
  nlohmann::json blocks = nlohmann::json::array();
  for (const auto& [id, block] : *build.program) blocks.push_back(blockToJson(block, options));
  nlohmann::json document = {{"blocks", blocks}, {"problems", toJson(build.problems)}};
  if (options.memory) document["memory"] = memoryToJson(build);
  print(document);
}

int listListings(const Build& built, const ListOptions& options) {
  const ListingOptions chosen{options.code, options.listing, options.symbols};
  options.json ? print(listingsToJson(built, chosen)) : printListings(built, chosen);
  return exitCode(built);
}

int listView(const Build& built, const ListOptions& options) {
  const diagram::View view = options.view == "kop" ? diagram::View::Kop : diagram::View::Fup;
  diagram::Options chosen{.mnemonics = {}, .symbols = options.symbols};
  if (!options.mnemonics.empty()) chosen.mnemonics = mnemonicsOf(options);
  if (!options.svg.empty()) return writeView(built, view, chosen, options.svg);
  if (options.json)
    print({{"networks", viewToJson(built, view, chosen)}, {"problems", toJson(built.problems)}});
  else
    printView(built, view, chosen);
  return exitCode(built);
}

Build unusable(const Problem& problem) {
  Build none;
  none.problems.add(problem);
  none.project.unreadable = true;
  return none;
}

Build buildOf(const ListOptions& options) {
  if (options.card.empty()) return build(loadProject(options.path, options.project), false);
  const auto card = openCard(options.card, true);
  return card ? buildFromCard(*card, options.card, options.project.cpu) : unusable(card.error());
}

int list(const ListOptions& options) {
  if (options.path.empty() == options.card.empty()) {
    std::cerr << "merker list: either PATH or --card must be given\n";
    return kUsage;
  }
  const Build built = buildOf(options);
  printProblems(built.problems, built.files());
  if (built.program == nullptr) return exitCode(built);
  if (!options.view.empty()) return listView(built, options);
  if (built.isListing()) return listListings(built, options);
  if (options.json)
    printJson(built, options);
  else if (options.memory)
    printMemory(built);
  else
    printTable(built, options);
  return exitCode(built);
}

}  // namespace

void addList(CLI::App& program, int& result) {
  auto* command =
      program.add_subcommand("list", "blocks with name, lengths in bytes, version and checksum");
  auto options = std::make_shared<ListOptions>();
  command->add_option("PATH", options->path, "project folder or source");
  command->add_option("--card", options->card, "instead of PATH: the program on this memory card");
  command->add_flag("--code", options->code, "each block disassembled, with its machine code");
  command->add_flag("--memory", options->memory,
                    "load, work and system memory, and how much of the CPU is in use");
  auto* view = command->add_option("--view", options->view,
                                   "the networks as ladder (kop) or function blocks (fup)");
  view->check(CLI::IsMember({"kop", "fup"}));
  command->add_option("--svg", options->svg, "with --view: as a picture into this file")
      ->needs(view);
  command->add_flag("--listing", options->listing,
                    "STEP 5: the program as a listing that compiles to the same machine code");
  command->add_flag("--symbols", options->symbols,
                    "in a view or a listing: the symbol where an operand has one");
  command
      ->add_option("--mnemonics", options->mnemonics,
                   "de or en; otherwise de, of a --view as the source has it")
      ->check(CLI::IsMember({"de", "en"}));
  addProjectOptions(*command, options->project);
  command->add_flag("--json", options->json, "as one JSON object");
  command->footer(
      "Columns: load = length of the block in load memory, work = machine code or actual values,\n"
      "local = local data;\n"
      "STEP 5: words = length of the block with its header.\n"
      "Examples:\n  merker list examples/sorting-plant\n  merker list blink.awl --code --mnemonics "
      "en\n"
      "  merker list blink.awl --view kop --svg blink.svg\n"
      "  merker list --card plant.card\n"
      "  merker list examples/vessel-emptying --view fup --symbols");
  command->callback([options, &result] { result = list(*options); });
}

}  // namespace merker::app
