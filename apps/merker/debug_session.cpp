#include "debug_session.h"

#include <fmt/format.h>

#include <ostream>

#include "base/text.h"
#include "scenario/line.h"

namespace merker::app {

// In the order in which `help` shows them; docs/debug.md describes the same commands.
const std::vector<DebugSession::Command>& DebugSession::commands() {
  using S = DebugSession;
  static const std::vector<Command> list = {
      {"help", "h", "[COMMAND]", "the commands, or one of them", &S::help},
      {"break", "b", "[PLACE]",
       "HALT before this place: FC 1:12, plant.awl:20, 20, FC 1 network 2, "
       "FC 1 byte 6; without a place: all breakpoints",
       &S::breakAt},
      {"delete", "", "NUMBER|all", "delete a breakpoint", &S::deletePoint},
      {"enable", "", "NUMBER|all", "enable a breakpoint", &S::enable},
      {"disable", "", "NUMBER|all", "disable a breakpoint", &S::disable},
      {"run", "r", "[TIME]", "warm restart, then as `continue`", &S::run},
      {"continue", "c", "[TIME]", "run to a breakpoint or STOP, at most this long (60s)", &S::goOn},
      {"step", "s", "", "the next statement, also into a called block", &S::step},
      {"next", "n", "", "the next statement of this block; calls run through", &S::next},
      {"out", "o", "", "run to the end of this block", &S::out},
      {"stepi", "si", "", "one machine instruction", &S::stepInstruction},
      {"cycle", "", "[COUNT]", "run to the end of the cycle, or for COUNT cycles", &S::cycle},
      {"until", "u", "TIME", "run until this virtual time", &S::until},
      {"restart", "", "[warm|cold]", "restart, to STARTUP before its first instruction",
       &S::restart},
      {"stop", "", "", "set the CPU to STOP", &S::stop},
      {"where", "w", "", "B stack: the running blocks, the innermost first", &S::where},
      {"registers", "reg", "", "accumulators, status word, address and data block registers",
       &S::registers},
      {"locals", "l", "[DEPTH]", "declared variables of the running block, or of one of `where`",
       &S::locals},
      {"stack", "", "", "I stack and L stack", &S::stack},
      {"list", "ls", "[PLACE]", "source lines around the place; again: the next ones", &S::list},
      {"status", "", "on [BLOCK] [from BLOCK] [db N] [di N] | off | all",
       "program status: VKE, STA "
       "and AKKU1 after each statement as the last call left them; `all`: every register",
       &S::status},
      {"print", "p", "OPERAND [FORMAT], ...",
       "values; formats: BOOL BIN HEX DEC UDEC BCD CHAR REAL "
       "S5TIME TIME DATE TOD COUNTER POINTER",
       &S::print},
      {"set", "", "OPERAND = VALUE, ...", "write values; an input at its terminal", &S::set},
      {"force", "", "[OPERAND = VALUE, ...]",
       "hold inputs and outputs; without operand: all forces", &S::force},
      {"unforce", "", "[OPERAND, ...]", "delete these forces, or all", &S::unforce},
      {"watch", "", "[OPERAND [FORMAT], ...]", "show values whenever the program pauses",
       &S::watch},
      {"unwatch", "", "NUMBER|all", "delete one of them", &S::unwatch},
      {"diag", "d", "[COUNT]", "diagnostic buffer, newest first (10 entries)", &S::diagnostics},
      {"info", "i", "", "module information: state, times, memory", &S::information},
      {"blocks", "", "", "the blocks of the program", &S::blocks},
      {"xref", "x", "OPERAND, ...", "where the program uses an operand", &S::references},
      {"quit", "q", "", "leave; the end of the input does the same", &S::quit},
  };
  return list;
}

DebugSession::DebugSession(const Build& build, std::ostream& out, std::function<bool()> interrupted)
    : build_(build),
      out_(out),
      interrupted_(std::move(interrupted)),
      plc_(build.controller()),
      monitor_(monitor::monitorOf(*plc_, build.project.symbols, build.resolver())),
      watches_(monitor_->addTable()) {
  plc_->memoryReset();
  if (const auto ob1 = monitor_->program().find({BlockKind::OB, 1})) currentFile_ = ob1->file();
}

std::vector<std::string> DebugSession::words() {
  std::vector<std::string> list;
  for (const Command& command : commands()) list.emplace_back(command.name);
  return list;
}

// The whole name, its short form, or a beginning that only one command has.
const DebugSession::Command* DebugSession::find(std::string_view word) {
  const Command* found = nullptr;
  unsigned matches = 0;
  for (const Command& command : commands()) {
    if (equalsIgnoreCase(word, command.name) || equalsIgnoreCase(word, command.alias))
      return &command;
    if (!equalsIgnoreCase(command.name.substr(0, word.size()), word)) continue;
    found = &command;
    ++matches;
  }
  return matches == 1 ? found : nullptr;
}

void DebugSession::greet() {
  out_ << plc_->modelName() << " with " << build_.blocks()
       << " blocks, in STOP. `help` lists the commands, `run` starts.\n";
}

bool DebugSession::execute(std::string_view line) {
  std::string_view rest = trim(line);
  if (rest.empty()) rest = lastStep_;
  if (rest.empty() || rest.starts_with("#")) return true;
  const std::string whole(rest);
  rest = whole;
  const std::string_view word = simulator::takeWord(rest);
  const Command* command = find(word);
  if (command == nullptr) {
    error(makeProblem(ProblemCode::P1215, Position{}, std::string(word)));
    return true;
  }
  if (command->arguments.empty() && !rest.empty()) {
    error(fmt::format("'{}' takes no argument: '{}'", command->name, rest));
    return true;
  }
  const bool repeats = command->name == "step" || command->name == "next" ||
                       command->name == "stepi" || command->name == "list";
  lastStep_ = repeats ? std::string(command->name) : std::string();
  (this->*command->run)(rest);
  out_ << std::flush;
  return !leaving_;
}

void DebugSession::help(std::string_view arguments) {
  if (!arguments.empty()) {
    const Command* command = find(arguments);
    if (command == nullptr)
      return error(makeProblem(ProblemCode::P1215, Position{}, std::string(arguments)));
    out_ << fmt::format("{} {}\n  {}\n", command->name, command->arguments, command->help);
    if (!command->alias.empty()) out_ << fmt::format("  short: {}\n", command->alias);
    return;
  }
  for (const Command& command : commands()) {
    const std::string left =
        fmt::format("{:<10} {:<4} {}", command.name, command.alias, command.arguments);
    out_ << (left.size() > 40 ? left + "\n" + std::string(41, ' ') : fmt::format("{:<41}", left))
         << command.help << '\n';
  }
}

void DebugSession::error(const std::string& text) {
  failed_ = true;
  out_ << "error: " << text << '\n';
}

void DebugSession::error(const Problem& problem) {
  error(fmt::format("{} [{}]", problem.message, problem.name()));
}

monitor::LocationContext DebugSession::here() const { return monitor_->locations(currentFile_); }

}  // namespace merker::app
