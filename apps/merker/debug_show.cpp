// Commands of `merker debug` that look at the CPU and the program.
#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "debug_number.h"
#include "debug_session.h"
#include "monitor/block_list.h"
#include "monitor/cross_reference.h"
#include "monitor_text.h"

namespace merker::app {
namespace {

constexpr std::uint32_t kListed = 5;  // lines before and behind
constexpr std::uint32_t kDiagnostics = 10;

}  // namespace

void DebugSession::where(std::string_view) {
  const monitor::Stacks stacks = monitor_->stacks();
  if (stacks.empty())
    out_ << monitor::name(plc_->mode())
         << ": stacks show the program in HALT and STOP; no block is running here\n";
  else
    out_ << blockStackText(stacks);
}

void DebugSession::registers(std::string_view) { out_ << registersText(monitor_->registers()); }

void DebugSession::locals(std::string_view arguments) {
  const auto depth = arguments.empty() ? 0 : number(arguments);
  if (!depth)
    return error(
        fmt::format("'{}' is not a valid depth; `where` numbers the blocks from 0", arguments));
  const auto variables = monitor_->variables(*depth);
  if (variables.empty()) out_ << "no declared variables here\n";
  for (const monitor::FrameVariable& one : variables)
    out_ << fmt::format("{:<7} #{:<20} {:<12} {}\n", one.section, one.name, one.type,
                        one.value.value_or("-"));
}

void DebugSession::stack(std::string_view) {
  const monitor::Stacks stacks = monitor_->stacks();
  if (stacks.empty()) return where({});
  out_ << "I stack\n" << interruptStackText(stacks);
  if (!stacks.locals.empty()) out_ << "L stack\n" << localStackText(stacks);
}

std::string_view DebugSession::sourceLine(const std::string& file, std::uint32_t line) const {
  const source::SourceFile* source = build_.project.file(file);
  if (source == nullptr || line == 0 || line > source->lineCount()) return {};
  return source->line(line);
}

// `=>` where the program stands, `*` where a breakpoint is.
void DebugSession::printSource(const monitor::SourcePlace& place, std::uint32_t around) {
  const source::SourceFile* source = build_.project.file(place.file);
  if (source == nullptr || place.line == 0) return;
  const auto position = monitor_->debugger().position();
  const std::uint32_t first = place.line > around ? place.line - around : 1;
  const std::uint32_t last = std::min(source->lineCount(), place.line + around);
  const auto& points = monitor_->debugger().breakpoints();
  for (std::uint32_t line = first; line <= last; ++line) {
    const bool here = position && position->file == place.file && position->line == line;
    const bool point = std::ranges::any_of(points, [&](const monitor::Breakpoint& one) {
      return one.place.file == place.file && one.place.line == line;
    });
    out_ << fmt::format("{}{} {:>4}  {}\n", here ? "=>" : "  ", point ? '*' : ' ', line,
                        source->line(line));
  }
  listedTo_ = last;
}

void DebugSession::list(std::string_view arguments) {
  if (!arguments.empty()) {
    const auto place = monitor::findLocation(arguments, here());
    if (!place) return error(place.error());
    currentFile_ = place->file;
    return printSource(*place, kListed);
  }
  monitor::SourcePlace place;
  const auto position = monitor_->debugger().position();
  place.file = currentFile_;
  const bool going =
      listedTo_ > 0 && lastStep_ == "list" && !(position && listedTo_ == position->line);
  place.line = going ? listedTo_ + kListed + 1 : position ? position->line : kListed + 1;
  printSource(place, kListed);
}

void DebugSession::diagnostics(std::string_view arguments) {
  const auto count = arguments.empty() ? kDiagnostics : number(arguments);
  if (!count || *count == 0)
    return error(fmt::format("'{}' is not a valid number of entries", arguments));
  out_ << diagnosticsText(monitor_->diagnostics(), *count);
}

void DebugSession::information(std::string_view) {
  out_ << informationText(monitor_->information());
}

void DebugSession::blocks(std::string_view) {
  for (const monitor::BlockRow& row : monitor::blockList(build_.code()))
    out_ << fmt::format("{:<8} {:<24} {:>6} {}s\n", toString(row.id), row.symbol, row.work,
                        name(monitor_->program().unit()));
}

void DebugSession::references(std::string_view arguments) {
  const auto all = monitor::crossReferences(build_.code(), build_.project.symbols,
                                            {.library = build_.library.get()});
  const auto part = monitor::filtered(all, arguments, monitor_->resolver(),
                                      monitor::filterWords(build_.code()), build_.project.symbols);
  if (!part) return error(part.error());
  if (part->empty()) out_ << "no instruction uses it\n";
  for (const monitor::CrossReference& row : *part)
    out_ << fmt::format("{:<12} {:<3} {:<20} {}, network {}\n", row.operand, monitor::name(row.use),
                        row.instruction, monitor::toString(row.place), row.place.network);
}

}  // namespace merker::app
