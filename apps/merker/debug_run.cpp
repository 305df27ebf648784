// Commands of `merker debug` that move time.
#include <fmt/format.h>

#include <ostream>

#include "base/text.h"
#include "debug_number.h"
#include "debug_session.h"
#include "monitor_text.h"
#include "scenario/duration.h"

namespace merker::app {
namespace {

// How long `continue` runs when nothing stops it, and how long a step may take (a called block that
// does not end).
constexpr Duration kLongestRun = Duration::seconds(60);

}  // namespace

// Nothing goes on from STOP: a restart would clear what somebody may be looking at.
bool DebugSession::going() {
  if (plc_->mode() != controller::Mode::Stop) return true;
  error("the CPU is in STOP; `run` or `restart` starts it");
  return false;
}

std::optional<Duration> DebugSession::longestRun(std::string_view arguments) {
  if (arguments.empty()) return kLongestRun;
  const auto time = simulator::parseDuration(arguments);
  if (!time) error(makeProblem(ProblemCode::P0953, Position{}, std::string(arguments)));
  return time;
}

void DebugSession::goOnFor(Duration longest) {
  report(monitor_->debugger().run(plc_->now() + longest, interrupted_));
}

void DebugSession::run(std::string_view arguments) {
  const auto longest = longestRun(arguments);
  if (longest && start(Start::Usual)) goOnFor(*longest);
}

void DebugSession::goOn(std::string_view arguments) {
  const auto longest = longestRun(arguments);
  if (longest && going()) goOnFor(*longest);
}

void DebugSession::until(std::string_view arguments) {
  const auto time = simulator::parseDuration(arguments);
  if (!time) return error(makeProblem(ProblemCode::P0953, Position{}, std::string(arguments)));
  const Instant end = Instant{} + *time;
  if (end <= plc_->now())
    return error(fmt::format("it is {} already", simulator::formatTime(plc_->now())));
  if (going()) report(monitor_->debugger().run(end, interrupted_));
}

void DebugSession::cycle(std::string_view arguments) {
  const auto count = arguments.empty() ? 1 : number(arguments);
  if (!count || *count == 0)
    return error(fmt::format("'{}' is not a valid number of cycles", arguments));
  if (!going()) return;
  const std::uint64_t last = plc_->cycles() + *count;
  const Instant limit = plc_->now() + kLongestRun;
  monitor::Pause pause;
  const auto there = [&] { return plc_->cycles() >= last || (interrupted_ && interrupted_()); };
  // one piece of work at a time: the end of a cycle is no instant one could know before
  while (!there() && plc_->now() < limit && pause.why == monitor::Pause::Why::Limit)
    pause = monitor_->debugger().runToCheckpoint(limit);
  report(pause);
  if (plc_->cycles() < last && pause.why == monitor::Pause::Why::Limit && plc_->now() >= limit)
    out_ << fmt::format("the limit of {} is reached; {} cycles are left\n",
                        simulator::formatTime(Instant{} + kLongestRun), last - plc_->cycles());
}

void DebugSession::stepBy(monitor::StepKind kind) {
  if (!going()) return;
  report(monitor_->debugger().step(kind, plc_->now() + kLongestRun, interrupted_));
}

void DebugSession::restart(std::string_view arguments) {
  const bool cold = equalsIgnoreCase(arguments, "cold");
  if (!cold && !arguments.empty() && !equalsIgnoreCase(arguments, "warm"))
    return error("restart must be 'warm' or 'cold'");
  const Start kind = cold ? Start::Cold : arguments.empty() ? Start::Usual : Start::Warm;
  if (start(kind)) out_ << monitor::name(plc_->mode()) << '\n';
}

// What is usual differs: a SINUMERIK does a cold restart.
bool DebugSession::start(Start kind) {
  monitor_->stop();
  const bool cold = kind == Start::Cold;
  const bool started = cold                  ? plc_->coldRestart()
                       : kind == Start::Warm ? plc_->warmRestart()
                                             : plc_->start();
  if (started) return true;
  error(cold && !plc_->hasColdRestart() ? plc_->modelName() + " has no cold restart"
                                        : "the CPU does not start: " + plc_->stopReason());
  return false;
}

void DebugSession::stop(std::string_view) {
  monitor_->stop();
  out_ << "STOP\n";
}

void DebugSession::report(const monitor::Pause& pause) {
  using Why = monitor::Pause::Why;
  if (pause.why == Why::Interrupted)  // stand where one can look around
    monitor_->debugger().step(monitor::StepKind::Into, plc_->now() + kLongestRun);
  const std::string time = simulator::formatTime(plc_->now());
  const auto place = monitor_->debugger().position();
  const bool stopped = plc_->mode() == controller::Mode::Stop;
  out_ << monitor::name(plc_->mode());
  if (pause.why == Why::Breakpoint) out_ << fmt::format(" at breakpoint {}", pause.breakpoint);
  if (stopped && !plc_->stopReason().empty()) out_ << ": " << plc_->stopReason();
  out_ << fmt::format(", {}, cycle {}\n", time, plc_->cycles() + 1);
  const bool standing = plc_->mode() == controller::Mode::Halt || (stopped && place);
  if (standing && place) {
    if (!place->file.empty()) currentFile_ = place->file;
    listedTo_ = 0;
    if (!stopped)
      out_ << fmt::format("{}, network {}\n", monitor::toString(*place), place->network);
    const auto block = monitor_->program().find(place->block);
    if (block && monitor::endsBlock(*block, place->offset))
      out_ << fmt::format("at the end of {}, behind\n", toString(place->block));
    printSource(*place, 0);
  }
  const monitor::ProgramStatus* shown = monitor_->debugger().status();
  if (shown != nullptr && standing && place && place->block == shown->code().id()) {
    const monitor::Registers r = monitor_->registers();
    out_ << fmt::format("VKE {:d}  STA {:d}  AKKU1 {:08X}\n", r.rlo, r.sta, r.accu[0]);
  }
  printWatches();
}

}  // namespace merker::app
