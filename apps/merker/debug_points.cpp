// Commands of `merker debug`: breakpoints and program status.
#include <fmt/format.h>

#include <ostream>

#include "base/text.h"
#include "debug_number.h"
#include "debug_session.h"
#include "scenario/line.h"

namespace merker::app {
namespace {

// The first `count` characters, which take one or more bytes of UTF-8 each.
std::string_view takeCharacters(std::string_view text, std::size_t count) {
  std::size_t bytes = 0;
  const auto continues = [&] { return (static_cast<unsigned char>(text[bytes]) & 0xC0) == 0x80; };
  for (; count > 0 && bytes < text.size(); --count) {
    ++bytes;
    while (bytes < text.size() && continues()) ++bytes;
  }
  return text.substr(0, bytes);
}

std::string hex(const std::optional<std::uint32_t>& value) {
  return value ? fmt::format("{:08X}", *value) : "-";
}

// A block's name takes one word ("FC1", a symbol) or two ("FC 1").
std::string takeBlock(std::string_view& rest) {
  std::string text(simulator::takeWord(rest));
  if (text.starts_with('"'))
    while (!rest.empty() && (text.size() < 2 || !text.ends_with('"')))
      text.append(" ").append(simulator::takeWord(rest));
  else if (!text.starts_with('-') && text.find_first_of("0123456789") == std::string::npos)
    text.append(" ").append(simulator::takeWord(rest));
  return text;
}

}  // namespace

void DebugSession::breakAt(std::string_view arguments) {
  monitor::Debugger& debugger = monitor_->debugger();
  if (arguments.empty()) {
    for (const monitor::Breakpoint& one : debugger.breakpoints())
      out_ << fmt::format("{:>3}  {:<40} network {}, {} hits{}\n", one.number,
                          monitor::toString(one.place), one.place.network, one.hits,
                          one.enabled ? "" : ", disabled");
    if (debugger.breakpoints().empty()) out_ << "no breakpoints\n";
    return;
  }
  const auto place = monitor::findLocation(arguments, here());
  if (!place) return error(place.error());
  const monitor::Breakpoint& point = debugger.setBreakpoint(*place);
  out_ << fmt::format("breakpoint {} at {}, network {}\n", point.number,
                      monitor::toString(point.place), point.place.network);
  printSource(point.place, 0);
}

void DebugSession::pointNotFound(std::string_view arguments) {
  error(fmt::format("breakpoint '{}' not found; 'break' lists them", arguments));
}

std::optional<std::uint32_t> DebugSession::pointNumber(std::string_view arguments) {
  const auto which = number(arguments);
  if (arguments.empty())
    error("the number of a breakpoint or 'all' is expected; 'break' lists them");
  else if (!which)
    pointNotFound(arguments);
  return which;
}

void DebugSession::deletePoint(std::string_view arguments) {
  if (equalsIgnoreCase(arguments, "all")) return monitor_->debugger().removeBreakpoints();
  const auto which = pointNumber(arguments);
  if (which && !monitor_->debugger().removeBreakpoint(*which)) pointNotFound(arguments);
}

void DebugSession::switchPoint(std::string_view arguments, bool on) {
  if (equalsIgnoreCase(arguments, "all")) return monitor_->debugger().enableBreakpoints(on);
  const auto which = pointNumber(arguments);
  if (which && !monitor_->debugger().enableBreakpoint(*which, on)) pointNotFound(arguments);
}

void DebugSession::status(std::string_view arguments) {
  std::string_view rest = arguments;
  const std::string_view word = simulator::takeWord(rest);
  if (equalsIgnoreCase(word, "on")) {
    if (showStatusOf(rest))
      out_ << fmt::format("program status of {} is on\n",
                          toString(monitor_->debugger().status()->code().id()));
  } else if (equalsIgnoreCase(word, "off")) {
    monitor_->debugger().hideStatus();
    out_ << "program status is off\n";
  } else if (word.empty() || equalsIgnoreCase(word, "all")) {
    printStatus(!word.empty());
  } else {
    error("use status [on [BLOCK] [from BLOCK] [db N] [di N] | off | all]");
  }
}

// The block, or the one where the program stands, and under which circumstances it is called.
bool DebugSession::showStatusOf(std::string_view rest) {
  std::optional<BlockId> block;
  monitor::CallEnvironment environment;
  while (!rest.empty()) {
    std::string_view behind = rest;
    const std::string_view word = simulator::takeWord(behind);
    const bool from = equalsIgnoreCase(word, "from"), db = equalsIgnoreCase(word, "db");
    if ((db || equalsIgnoreCase(word, "di")) && block) {
      if (!db && !monitor_->registers().di) return error("this PLC has no DI register"), false;
      const auto value = number(simulator::takeWord(behind));
      if (!value || *value > 0xFFFF) return error("a number of a data block is expected"), false;
      (db ? environment.db : environment.di) = static_cast<std::uint16_t>(*value);
      rest = behind;
      continue;
    }
    if (from) rest = behind;
    const auto id = monitor::findBlock(takeBlock(rest), here());
    if (!id) return error(id.error()), false;
    from ? environment.caller = *id : block = *id;
  }
  const auto place = monitor_->debugger().position();
  if (!block) block = place ? place->block : BlockId{BlockKind::OB, 1};
  if (monitor_->debugger().showStatus(*block, environment)) return true;
  return error(makeProblem(ProblemCode::P1207, Position{}, toString(*block))), false;
}

// The line; where it holds several statements, the part of this one.
std::string DebugSession::statementText(const std::string& file,
                                        const std::vector<monitor::StatusRow>& rows,
                                        std::size_t row) const {
  const auto same = [&](std::size_t other) {
    return other < rows.size() && rows[other].statement.line == rows[row].statement.line;
  };
  std::string_view line = sourceLine(file, rows[row].statement.line);
  const std::size_t begin = rows[row].statement.column;
  if (begin == 0 || (!same(row - 1) && !same(row + 1))) return std::string(line);
  if (same(row + 1)) line = takeCharacters(line, rows[row + 1].statement.column - 1);
  const std::string_view before = same(row - 1) ? takeCharacters(line, begin - 1) : "";
  return std::string(before.size(), ' ') + std::string(line.substr(before.size()));
}

void DebugSession::printStatus(bool everything) {
  const monitor::ProgramStatus* status = monitor_->debugger().status();
  if (status == nullptr) return error("program status is off; 'status on FC 1' switches it on");
  const std::string block = toString(status->code().id());
  if (status->calls() == 0) {
    const bool others = status->otherCalls() > 0;
    out_ << block
         << (others ? " has been called, but not under the conditions of its program status\n"
                    : " has not been called since its program status was switched on\n");
    return;
  }
  out_ << fmt::format("{}, call {}\n", block, status->calls());
  out_ << " line  VKE STA AKKU1   "
       << (everything ? " AKKU2    AR1      AR2      STW  DB    DI  " : "") << " source\n";
  const std::vector<monitor::StatusRow> rows = status->rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const monitor::StatusRow& row = rows[i];
    const monitor::Registers& r = row.after;
    std::string text(everything ? 62 : 18, ' ');
    if (row.reached) {
      text = fmt::format("  {:d}   {:d}  {:08X} ", r.rlo, r.sta, r.accu[0]);
      if (everything)
        text += fmt::format("{:08X} {:>8} {:>8} {:04X} {:<5} {:<5}", r.accu[1], hex(r.ar1),
                            hex(r.ar2), r.word, r.db, r.di ? std::to_string(*r.di) : "-");
    }
    out_ << fmt::format("{:>5} {}  {}\n", row.statement.line, text,
                        statementText(status->code().file(), rows, i));
  }
}

}  // namespace merker::app
