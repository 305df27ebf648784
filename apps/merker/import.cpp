// merker import SOURCE [-o FOLDER]
#include "importing/import.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "base/code_page.h"
#include "base/visible.h"
#include "command.h"

namespace merker::app {
namespace {

int refuse(int code, const std::string& text) {
  std::cerr << "merker import: " << text << '\n';
  return code;
}

int importProject(const importing::Options& options) {
  const importing::Outcome outcome = importing::importSource(options);
  switch (outcome.result) {
    case importing::Result::Unreadable:
      return refuse(kUnreadable, fmt::format("{} cannot be read", visible(options.source)));
    case importing::Result::Nothing:
      return refuse(
          kUnreadable,
          fmt::format("{} contains nothing that can be imported: no STEP 7 project, program file "
                      "of STEP 5, source, "
                      "symbol table, block or station",
                      visible(options.source)) +
              (outcome.report.empty() ? "" : "\n" + outcome.report));
    case importing::Result::NoSuchProgram:
      return refuse(kUsage, outcome.programs.empty()
                                ? fmt::format("{} contains no programs to choose from",
                                              visible(options.source))
                                : fmt::format("program '{}' not found; the programs are: {}",
                                              options.program, fmt::join(outcome.programs, ", ")));
    case importing::Result::Exists:
      return refuse(kUnreadable,
                    fmt::format("{} exists and is not empty; choose another folder with -o",
                                visible(outcome.folder)));
    case importing::Result::Unwritable:
      return refuse(kUnreadable, outcome.report);
    case importing::Result::Stopped:  // nobody stops it here
    case importing::Result::Imported:
      break;
  }
  std::cout << outcome.report << "\nwritten to " << visible(outcome.folder) << '\n';
  return outcome.lost ? kProblems : kGood;
}

}  // namespace

void addImport(CLI::App& program, int& result) {
  auto* command = program.add_subcommand(
      "import",
      "a project folder from a STEP 7 project, a program of STEP 5, their zip, sources, symbols, "
      "blocks or a station");
  auto options = std::make_shared<importing::Options>();
  command
      ->add_option("SOURCE", options->source, "folder, zip or file; what it is shows its content")
      ->required();
  command->add_option(
      "-o,--output", options->folder,
      "new folder of the project; default: named after SOURCE, in the current folder");
  command->add_option("--program", options->program, "only the program of this name");
  auto codePage = std::make_shared<unsigned>(0);
  command
      ->add_option("--code-page", *codePage,
                   "of texts: 437 or 850 for files of STEP 5; 1250 to 1254, 866, 932, 936 and "
                   "others for sources, symbols and projects that do not name theirs")
      ->check(CLI::IsMember(std::vector<unsigned>(std::begin(kCodePages), std::end(kCodePages))));
  command->footer(
      "SOURCE: a STEP 7 V5 project (*.s7p) or library folder, a zip of it, a block folder of one; "
      "AWL\n"
      "sources; program files (*.S5D) and listings of STEP 5; symbol tables (.sdf .asc .dif .seq); "
      "HW Config "
      "exports (.cfg); blocks and WLD "
      "files.\n"
      "A project with several programs becomes one folder for each. The report also stands in\n"
      "FOLDER/import-report.txt. Existing files are never overwritten.\n"
      "Exit codes: 0 all came, 1 something did not come, 4 SOURCE or FOLDER cannot be used. Files\n"
      "beside a program that are of no known kind are named and are no loss.\n"
      "Examples:\n  merker import PLANT.zip -o plant\n  merker import /old/Plant --program \"S7 "
      "Program(1)\"");
  command->callback([options, codePage, &result] {
    options->codePage = *codePage == 850 ? Encoding::Cp850 : Encoding::Cp437;
    options->page = *codePage;
    result = importProject(*options);
  });
}

}  // namespace merker::app
