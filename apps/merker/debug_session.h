// The prompt of `merker debug`: one command a line over the monitor. Virtual time moves only while
// a command runs the program.
#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "build.h"
#include "monitor/monitor.h"

namespace merker::app {

class DebugSession {
 public:
  // `interrupted` is asked while the program runs. The build and the stream outlive the session.
  DebugSession(const Build& build, std::ostream& out, std::function<bool()> interrupted);

  // False: the user wants to leave. An empty line repeats a step.
  bool execute(std::string_view line);
  bool failed() const { return failed_; }  // a command could not be carried out
  void greet();
  static std::vector<std::string> words();

 private:
  struct Command {
    std::string_view name, alias, arguments, help;  // `arguments` empty: it takes none
    void (DebugSession::*run)(std::string_view arguments);
  };
  static const std::vector<Command>& commands();
  static const Command* find(std::string_view word);

  // debug_session.cpp
  void help(std::string_view arguments);
  void quit(std::string_view) { leaving_ = true; }
  void error(const std::string& text);
  void error(const Problem& problem);
  // debug_run.cpp
  void run(std::string_view arguments);
  void goOn(std::string_view arguments);
  void until(std::string_view arguments);
  void cycle(std::string_view arguments);
  void step(std::string_view) { stepBy(monitor::StepKind::Into); }
  void next(std::string_view) { stepBy(monitor::StepKind::Over); }
  void out(std::string_view) { stepBy(monitor::StepKind::Out); }
  void stepInstruction(std::string_view) { stepBy(monitor::StepKind::Instruction); }
  void restart(std::string_view arguments);
  void stop(std::string_view);
  void stepBy(monitor::StepKind kind);
  bool going();
  enum class Start : std::uint8_t { Usual, Warm, Cold };
  bool start(Start kind);
  std::optional<Duration> longestRun(std::string_view arguments);
  void goOnFor(Duration longest);
  void report(const monitor::Pause& pause);
  // debug_points.cpp
  void breakAt(std::string_view arguments);
  void deletePoint(std::string_view arguments);
  void enable(std::string_view arguments) { switchPoint(arguments, true); }
  void disable(std::string_view arguments) { switchPoint(arguments, false); }
  std::optional<std::uint32_t> pointNumber(std::string_view arguments);
  void pointNotFound(std::string_view arguments);
  void switchPoint(std::string_view arguments, bool on);
  void status(std::string_view arguments);
  bool showStatusOf(std::string_view arguments);
  void printStatus(bool everything);
  std::string statementText(const std::string& file, const std::vector<monitor::StatusRow>& rows,
                            std::size_t row) const;
  // debug_show.cpp
  void where(std::string_view);
  void registers(std::string_view);
  void locals(std::string_view arguments);
  void stack(std::string_view);
  void list(std::string_view arguments);
  void diagnostics(std::string_view arguments);
  void information(std::string_view);
  void blocks(std::string_view);
  void references(std::string_view arguments);
  void printSource(const monitor::SourcePlace& place, std::uint32_t around);
  std::string_view sourceLine(const std::string& file, std::uint32_t line) const;
  // debug_values.cpp
  void print(std::string_view arguments);
  void set(std::string_view arguments);
  void force(std::string_view arguments);
  void unforce(std::string_view arguments);
  void watch(std::string_view arguments);
  void unwatch(std::string_view arguments);
  void printWatches();
  Problem whyWrong(std::string_view text, const Problem& problem) const;
  std::optional<std::vector<monitor::Wish>> wishes(std::string_view arguments);

  monitor::LocationContext here() const;

  const Build& build_;
  std::ostream& out_;
  std::function<bool()> interrupted_;
  std::unique_ptr<controller::Controller> plc_;
  std::unique_ptr<monitor::Monitor> monitor_;
  monitor::VariableTable& watches_;
  std::string lastStep_;     // what an empty line repeats
  std::string currentFile_;  // what a bare line number means
  std::uint32_t listedTo_ = 0;
  bool leaving_ = false, failed_ = false;
};

}  // namespace merker::app
