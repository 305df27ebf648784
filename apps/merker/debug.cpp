// merker debug PATH: a prompt over a running program.
#include <CLI/CLI.hpp>
#include <csignal>
#include <iostream>

#include "build.h"
#include "command.h"
#include "cpu_option.h"
#include "debug_session.h"
#include "line_editor.h"

namespace merker::app {
namespace {

volatile std::sig_atomic_t pressed = 0;  // Ctrl-C; a signal handler reaches nothing else

// While it lives, Ctrl-C pauses the program, and drops the line at the prompt, instead of ending
// Merker.
class InterruptKey {
 public:
  InterruptKey() {
    struct sigaction action = {};
    action.sa_handler = [](int) { pressed = 1; };
    sigaction(SIGINT, &action, &before_);
  }
  ~InterruptKey() { sigaction(SIGINT, &before_, nullptr); }
  InterruptKey(const InterruptKey&) = delete;
  InterruptKey& operator=(const InterruptKey&) = delete;

 private:
  struct sigaction before_ = {};
};

struct DebugOptions {
  ProjectOptions project;
  std::string path;
  std::vector<std::string> commands;
};

// The next line; an empty one if Ctrl-C dropped it, none at the end of the input.
std::optional<std::string> nextLine(LineEditor& editor) {
  pressed = 0;
  auto line = editor.read("(merker) ");
  if (!line && editor.onTerminal()) std::cout << '\n';
  if (!line && pressed != 0) return "";
  return line;
}

int prompt(const DebugOptions& options, const Build& built) {
  const InterruptKey key;
  DebugSession session(built, std::cout, [] { return pressed != 0; });
  LineEditor editor(DebugSession::words());
  if (editor.onTerminal()) session.greet();
  bool going = true;
  for (const std::string& command : options.commands) going = going && session.execute(command);
  while (going) {
    const auto line = nextLine(editor);
    going = line && session.execute(*line);
  }
  return session.failed() && !editor.onTerminal() ? kProblems : kGood;
}

int debug(const DebugOptions& options) {
  Build built = build(loadProject(options.path, options.project), false);
  requireOb1(built);
  if (!built.ok()) return report(built, false);
  printProblems(built.problems, built.files());
  return prompt(options, built);
}

}  // namespace

void addDebug(CLI::App& program, int& result) {
  auto* command = program.add_subcommand(
      "debug", "breakpoints, single step, program status: a prompt over the running program");
  auto options = std::make_shared<DebugOptions>();
  command->add_option("PATH", options->path, "project folder or source")->required();
  addProjectOptions(*command, options->project);
  command->add_option("-x,--execute", options->commands, "a command to begin with; several times")
      ->allow_extra_args(false);
  command->footer(
      "Time is virtual: it passes only while a command runs the program.\n"
      "Commands come from the terminal or, one per line, from a pipe; then the exit code is 1 if\n"
      "a command failed. `help` lists the commands, docs/debug.md describes them.\n"
      "Examples:\n"
      "  merker debug examples/sorting-plant\n"
      "  merker debug blink.awl -x \"break OB 1\" -x run\n"
      "  printf 'break FC 1:12\\nrun\\nwhere\\n' | merker debug plant");
  command->callback([options, &result] { result = debug(*options); });
}

}  // namespace merker::app
