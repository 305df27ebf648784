// merker export PATH -o FILE
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "base/code_page.h"
#include "build.h"
#include "command.h"
#include "cpu_option.h"
#include "exporting/format.h"

namespace merker::app {
namespace {

struct ExportOptions {
  ProjectOptions project;
  std::string path, output;
  unsigned codePage = 0;
  bool symbols = false, force = false;
};

int complain(const std::string& text, int code) {
  std::cerr << "merker export: " << text << '\n';
  return code;
}

int write(const std::vector<exporting::OutputFile>& files, bool force) {
  for (const exporting::OutputFile& file : files)
    if (!force && std::filesystem::exists(file.path))
      return complain(file.path + " already exists; --force replaces it", kUnreadable);
  for (const exporting::OutputFile& file : files) {
    std::ofstream out(file.path, std::ios::binary);
    out << file.bytes;
    out.close();
    if (!out)
      return complain(fmt::format("cannot write {}: {}", file.path, std::strerror(errno)),
                      kUnreadable);
    std::cout << fmt::format("{}: {} bytes\n", file.path, file.bytes.size());
  }
  return kGood;
}

int exportProgram(const ExportOptions& options) {
  const Build built = build(loadProject(options.path, options.project), false);
  printProblems(built.problems, built.files());
  if (!built.ok()) return exitCode(built);
  const exporting::Family family = exporting::familyOf(built);
  const exporting::Format* const format = exporting::formatOf(options.output, family);
  if (format == nullptr)
    return complain(fmt::format("{} has no extension that this program can be exported to; write "
                                "one of {}",
                                options.output, exporting::extensions(family)),
                    kUsage);
  exporting::Options chosen;
  chosen.codePage = options.codePage == 850 ? Encoding::Cp850 : Encoding::Cp437;
  chosen.page = options.codePage;
  chosen.symbols = options.symbols;
  const exporting::Output output = format->write(built, options.output, chosen);
  for (const std::string& warning : output.warnings) std::cerr << warning << '\n';
  if (output.files.empty() && !output.warnings.empty()) return kProblems;
  if (output.files.empty())
    return complain(fmt::format("the program has nothing for {}", options.output), kProblems);
  return write(output.files, options.force);
}

std::string formatList() {
  std::string text = "The extension of FILE chooses what is written:\n";
  for (const exporting::Format& format : exporting::formats())
    text += fmt::format("  {:<5} STEP {}: {}\n", format.extension,
                        format.family == exporting::Family::Step7 ? 7 : 5, format.what);
  return text +
         "Examples:\n  merker export plant -o plant.awl --symbols\n"
         "  merker export lamp.s5 -o LAMP@@ST.S5D\n"
         "  merker export control -o control.s5 --symbols";
}

}  // namespace

void addExport(CLI::App& program, int& result) {
  auto* command = program.add_subcommand("export", "writes a program as files of STEP 7 or STEP 5");
  auto options = std::make_shared<ExportOptions>();
  command->add_option("PATH", options->path, "project folder or source")->required();
  command->add_option("-o,--output", options->output, "the file")->required();
  command
      ->add_option("--code-page", options->codePage,
                   "of texts: 437 or 850 for STEP 5; 1250 to 1254, 932, 936 and others for STEP 7, "
                   "by default the one that has most of the characters")
      ->check(CLI::IsMember(std::vector<unsigned>(std::begin(kCodePages), std::end(kCodePages))));
  command->add_flag("--symbols", options->symbols,
                    "in a source or listing: symbols where operands have them");
  command->add_flag("--force", options->force, "replace existing files");
  addProjectOptions(*command, options->project);
  command->footer(formatList());
  command->callback([options, &result] { result = exportProgram(*options); });
}

}  // namespace merker::app
