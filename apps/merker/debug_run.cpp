// Commands of `merker debug` that move time.
#include <fmt/format.h>

#include <ostream>

#include "base/text.h"
#include "cpu/cpu.h"
#include "debug_session.h"
#include "monitor_text.h"
#include "simulator/duration.h"

namespace merker::app {
namespace {

// How long `continue` runs when nothing stops it, and how long a step may take (a called block that
// does not end).
constexpr Duration kLongestRun = Duration::seconds(60);

}  // namespace

// From STOP the program has to be started first.
bool DebugSession::started() {
  if (station_.mode() != station::Mode::Stop) return true;
  if (station_.warmRestart()) return true;
  error("the CPU does not start: " + station_.stopReason());
  return false;
}

void DebugSession::run(std::string_view arguments) {
  if (station_.mode() != station::Mode::Stop) station_.stop();
  goOn(arguments);
}

void DebugSession::goOn(std::string_view arguments) {
  Duration longest = kLongestRun;
  if (!arguments.empty()) {
    const auto time = simulator::parseDuration(arguments);
    if (!time) return error(makeProblem(ProblemCode::P0953, Position{}, std::string(arguments)));
    longest = *time;
  }
  if (started()) report(monitor_.debugger().run(station_.now() + longest, interrupted_));
}

void DebugSession::until(std::string_view arguments) {
  const auto time = simulator::parseDuration(arguments);
  if (!time) return error(makeProblem(ProblemCode::P0953, Position{}, std::string(arguments)));
  const Instant end = Instant{} + *time;
  if (end <= station_.now())
    return error(fmt::format("it is {} already", simulator::formatTime(station_.now())));
  if (started()) report(monitor_.debugger().run(end, interrupted_));
}

void DebugSession::cycle(std::string_view arguments) {
  std::uint64_t count = 1;
  if (!arguments.empty()) {
    const std::string text(arguments);
    char* end = nullptr;
    count = std::strtoull(text.c_str(), &end, 10);
    if (*end != 0 || count == 0) return error("'" + text + "' is no number of cycles");
  }
  if (!started()) return;
  const std::uint64_t last = station_.cycles() + count;
  const Instant limit = station_.now() + kLongestRun;
  monitor::Pause pause;
  const auto there = [&] { return station_.cycles() >= last || (interrupted_ && interrupted_()); };
  // one piece of work at a time: the end of a cycle is no instant one could know before
  while (!there() && station_.now() < limit && pause.why == monitor::Pause::Why::Limit)
    pause = monitor_.debugger().runToCheckpoint(limit);
  report(pause);
}

void DebugSession::stepBy(monitor::StepKind kind) {
  if (!started()) return;
  report(monitor_.debugger().step(kind, station_.now() + kLongestRun, interrupted_));
}

void DebugSession::restart(std::string_view arguments) {
  const bool cold = equalsIgnoreCase(arguments, "cold");
  if (!cold && !arguments.empty() && !equalsIgnoreCase(arguments, "warm"))
    return error("restart is warm or cold");
  if (station_.mode() != station::Mode::Stop) station_.stop();
  if (!(cold ? station_.coldRestart() : station_.warmRestart()))
    return error(cold && !station_.model().coldRestart
                     ? std::string(station_.model().name) + " has no cold restart"
                     : "the CPU does not start: " + station_.stopReason());
  out_ << monitor::name(station_.mode()) << '\n';
}

void DebugSession::stop(std::string_view) {
  station_.stop();
  out_ << "STOP\n";
}

void DebugSession::report(const monitor::Pause& pause) {
  using Why = monitor::Pause::Why;
  if (pause.why == Why::Interrupted)  // stand where one can look around
    monitor_.debugger().step(monitor::StepKind::Into, station_.now() + kLongestRun);
  const std::string time = simulator::formatTime(station_.now());
  const auto place = monitor_.debugger().position();
  const bool stopped = station_.mode() == station::Mode::Stop;
  out_ << monitor::name(station_.mode());
  if (pause.why == Why::Breakpoint) out_ << fmt::format(" at breakpoint {}", pause.breakpoint);
  if (stopped && !station_.stopReason().empty()) out_ << ": " << station_.stopReason();
  out_ << fmt::format(", {}, cycle {}\n", time, station_.cycles() + 1);
  const bool standing = station_.mode() == station::Mode::Halt || (stopped && place);
  if (standing && place) {
    if (!place->file.empty()) currentFile_ = place->file;
    listedTo_ = 0;
    if (!stopped)
      out_ << fmt::format("{}, network {}\n", monitor::toString(*place), place->network);
    printSource(*place, 0);
  }
  const monitor::ProgramStatus* shown = monitor_.debugger().status();
  if (shown != nullptr && standing && place && place->block == shown->block().id) {
    const cpu::Registers& r = station_.cpu().machine().registers;
    out_ << fmt::format("VKE {:d}  STA {:d}  AKKU1 {:08X}\n", r.status.rlo, r.status.sta,
                        r.accu[0]);
  }
  printWatches();
}

}  // namespace merker::app
