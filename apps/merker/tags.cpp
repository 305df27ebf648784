// merker tags PATH: the tag list of a project for other tools.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>

#include "build.h"
#include "command.h"
#include "cpu_option.h"
#include "tags/format.h"
#include "tags/tag.h"

namespace merker::app {
namespace {

struct TagsOptions {
  ProjectOptions project;
  std::string path, format = "csv", output, mnemonics = "de";
  bool symbolsOnly = false;
  tags::FormatOptions file;
};

constexpr std::size_t kMostNames = 5;  // of tags that a format cannot have

void tellLeft(const std::vector<std::string>& left, const std::string& format) {
  if (left.empty()) return;
  std::string names;
  for (std::size_t i = 0; i < std::min(left.size(), kMostNames); ++i)
    names += (names.empty() ? "" : ", ") + left[i];
  if (left.size() > kMostNames) names += ", ...";
  std::cerr << fmt::format("{} tags are left out, because {} has no address for them: {}\n",
                           left.size(), format, names);
}

int write(const tags::Output& output, const TagsOptions& options, std::size_t count) {
  if (options.output.empty()) {
    std::cout << output.text;
    return kGood;
  }
  std::ofstream out(options.output, std::ios::binary);
  out << output.text;
  out.close();
  if (!out) {
    std::cerr << fmt::format("merker tags: cannot write {}: {}\n", options.output,
                             std::strerror(errno));
    return kUnreadable;
  }
  std::cout << fmt::format("{}: {} tags\n", options.output, count);
  return kGood;
}

int listTags(const TagsOptions& options) {
  if (options.file.address.find(':') != std::string::npos) {
    std::cerr << "merker tags: --address must be an address without a port: FUXA asks port 102\n";
    return kUsage;
  }
  const Build built = build(loadProject(options.path, options.project), false);
  printProblems(built.problems, built.files());
  if (!built.ok()) return exitCode(built);
  const auto list = tags::listTags(built, {.data = !options.symbolsOnly});
  if (list.empty()) std::cerr << "the program has no symbols for operands and no data\n";
  const tags::Format& format = *tags::findFormat(options.format);
  tags::FormatOptions chosen = options.file;
  const bool english = options.mnemonics == "en" && !built.isListing();
  chosen.mnemonics = english ? Mnemonics::International : Mnemonics::German;
  const tags::Output output = format.write(list, chosen);
  tellLeft(output.left, options.format);
  return write(output, options, list.size() - output.left.size());
}

std::vector<std::string> formatNames() {
  std::vector<std::string> names;
  for (const tags::Format& format : tags::formats()) names.emplace_back(format.name);
  return names;
}

std::string formatList() {
  std::string text = "Formats:\n";
  for (const tags::Format& format : tags::formats())
    text += fmt::format("  {:<9} {}\n", format.name, format.what);
  return text +
         "Examples:\n"
         "  merker tags examples/sorting-plant\n"
         "  merker tags plant --format node-red -o plant.csv\n"
         "  merker tags plant --format ignition --device Press -o tags.json";
}

}  // namespace

void addTags(CLI::App& program, int& result) {
  auto* command = program.add_subcommand(
      "tags", "tag list for HMI and SCADA: symbols and variables of data blocks with addresses");
  auto options = std::make_shared<TagsOptions>();
  command->add_option("PATH", options->path, "project folder or source")->required();
  command->add_option("--format", options->format, "kind of file (default: csv)")
      ->check(CLI::IsMember(formatNames()));
  command->add_option("-o,--output", options->output, "file (default: standard output)");
  command->add_option("--device", options->file.device,
                      "name of the PLC in the other tool (default: PLC)");
  command->add_option("--address", options->file.address,
                      "fuxa: address of the S7 server (default: 127.0.0.1)");
  command->add_option("--mnemonics", options->mnemonics, "csv: de or en; STEP 5 has German ones")
      ->check(CLI::IsMember({"de", "en"}));
  command->add_flag("--symbols-only", options->symbolsOnly, "without the variables of data blocks");
  addProjectOptions(*command, options->project);
  command->footer(formatList());
  command->callback([options, &result] { result = listTags(*options); });
}

}  // namespace merker::app
