// merker: an open PLC in software. Commands, options and exit codes are described by `merker
// --help`.
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

#include "command.h"
#include "work_thread.h"

namespace {

// CLI11 has many exit codes of its own; here every wrong usage is 2.
int parse(CLI::App& program, int argc, char** argv, const int& result) {
  try {
    program.parse(argc, argv);
    return result;
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? merker::app::kGood : merker::app::kUsage;
  }
}

// "check, run, …".
std::string commands(const CLI::App& program) {
  std::string list;
  for (const CLI::App* command : program.get_subcommands({}))
    list += (list.empty() ? "" : ", ") + command->get_name();
  return list;
}

// CLI11 would call it an argument that was not expected.
bool isUnknownCommand(const CLI::App& program, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return false;
  for (const CLI::App* command : program.get_subcommands({}))
    if (command->check_name(argv[1])) return false;
  std::cerr << "merker: unknown command '" << argv[1]
            << "'; the commands are: " << commands(program) << '\n';
  return true;
}

// A full disk or a closed pipe is noticed here at the latest.
int written(int result) {
  std::cout.flush();
  if (std::cout) return result;
  std::cerr << "merker: cannot write to standard output\n";
  return merker::app::kUnreadable;
}

int run(int argc, char** argv) {
  CLI::App program{"Merker: an open PLC in software that runs STEP 7 programs and STEP 5 listings",
                   "merker"};
  program.set_version_flag("--version", std::string("merker ") + MERKER_VERSION);
  program.require_subcommand(1);
  program.footer(
      "PATH is a project folder (with merker.toml) or a single source: *.awl (STEP 7, on a CPU "
      "314C-2\n"
      "PtP) or *.s5 (STEP 5, on a SINUMERIK 810 GA3).\n"
      "Exit codes: 0 good, 1 problems in the sources or a check failed, 2 wrong usage,\n"
      "3 the CPU went to STOP through a fault, 4 a file could not be read or written.\n"
      "`merker COMMAND --help` shows the options and examples of a command.");
  int result = merker::app::kGood;
  merker::app::addCheck(program, result);
  merker::app::addRun(program, result);
  merker::app::addWorkbench(program, result);
  merker::app::addTest(program, result);
  merker::app::addCampaign(program, result);
  merker::app::addDebug(program, result);
  merker::app::addDiag(program, result);
  merker::app::addMonitor(program, result);
  merker::app::addXref(program, result);
  merker::app::addImport(program, result);
  merker::app::addList(program, result);
  merker::app::addHw(program, result);
  merker::app::addGsd(program, result);
  merker::app::addNetwork(program, result);
  merker::app::addDisassemble(program, result);
  merker::app::addAssemble(program, result);
  merker::app::addExport(program, result);
  merker::app::addTags(program, result);
  merker::app::addPlot(program, result);
  merker::app::addBench(program, result);
  if (isUnknownCommand(program, argc, argv)) return merker::app::kUsage;
  return written(parse(program, argc, argv, result));
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int result = run(argc, argv);
    // A thread that does not end still uses what cleaning up would take away.
    if (!merker::app::WorkThread::anyLeftBehind()) return result;
    std::cout.flush();
    std::_Exit(result);
  } catch (const std::exception& error) {  // out of memory and the like
    std::cerr << "merker: " << error.what() << '\n';
    return merker::app::kUnreadable;
  }
}
