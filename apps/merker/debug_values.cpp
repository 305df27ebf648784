// Commands of `merker debug` that show and change values.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <ostream>

#include "base/text.h"
#include "debug_number.h"
#include "debug_session.h"
#include "scenario/line.h"

namespace merker::app {
namespace {

bool isWord(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
  });
}

// "MW 10 HEX": the operand, and the format if the last word is one.
monitor::DisplayFormat takeFormat(std::string_view& text) {
  const std::size_t space = text.rfind(' ');
  if (space == std::string_view::npos) return monitor::DisplayFormat::Automatic;
  const auto format = monitor::parseFormat(text.substr(space + 1));
  if (!format) return monitor::DisplayFormat::Automatic;
  text = trim(text.substr(0, space));
  return *format;
}

}  // namespace

// What is wrong with "MW 10 FOO": the format, if the rest is an operand.
Problem DebugSession::whyWrong(std::string_view text, const Problem& problem) const {
  const std::size_t space = text.rfind(' ');
  if (space == std::string_view::npos || !isWord(text.substr(space + 1))) return problem;
  if (!monitor_->operand(trim(text.substr(0, space)))) return problem;
  const auto format = monitor::parseFormat(text.substr(space + 1));
  return format ? problem : format.error();
}

void DebugSession::print(std::string_view arguments) {
  if (arguments.empty()) return error("an operand is expected: print MW 10 HEX, A 0.0");
  std::string lines;
  for (const std::string_view part : simulator::splitList(arguments)) {
    std::string_view operand = part;
    const monitor::DisplayFormat format = takeFormat(operand);
    const auto value = monitor_->read(operand, format);
    if (!value) return error(whyWrong(part, value.error()));
    lines += fmt::format("{} = {}\n", operand, *value);
  }
  out_ << lines;
}

// "MW 10 = 5, ...": what is wrong with one of them stops all.
std::optional<std::vector<monitor::Wish>> DebugSession::wishes(std::string_view arguments) {
  std::vector<monitor::Wish> list;
  for (const std::string_view part : simulator::splitList(arguments)) {
    const std::size_t sign =
        simulator::findOutside(part, [](std::string_view rest) { return rest.front() == '='; });
    if (sign == std::string_view::npos) {
      error(fmt::format("'{}' is not OPERAND = VALUE", part));
      return std::nullopt;
    }
    std::string_view value = trim(part.substr(sign + 1));
    if (value.empty()) {
      error(fmt::format("a value is expected behind '{}'", part));
      return std::nullopt;
    }
    const monitor::DisplayFormat format = takeFormat(value);
    list.push_back({trim(part.substr(0, sign)), value, format});
  }
  return list;
}

void DebugSession::set(std::string_view arguments) {
  const auto list = wishes(arguments);
  if (!list) return;
  if (const auto problem = monitor_->write(*list)) error(*problem);
}

void DebugSession::force(std::string_view arguments) {
  if (arguments.empty()) {
    for (const monitor::Forced& one : monitor_->forces())
      out_ << fmt::format("{} = {}\n", one.operand.text,
                          monitor::show(one.operand, one.value, monitor::DisplayFormat::Automatic));
    if (monitor_->forces().empty()) out_ << "no forces\n";
    return;
  }
  const auto list = wishes(arguments);
  if (!list) return;
  if (const auto problem = monitor_->force(*list)) error(*problem);
}

void DebugSession::unforce(std::string_view arguments) {
  if (arguments.empty() || equalsIgnoreCase(arguments, "all")) return monitor_->unforceAll();
  if (const auto problem = monitor_->unforce(simulator::splitList(arguments))) error(*problem);
}

void DebugSession::watch(std::string_view arguments) {
  const std::size_t before = watches_.rows().size();
  if (!arguments.empty())
    for (std::string_view part : simulator::splitList(arguments)) {
      const monitor::DisplayFormat format = takeFormat(part);
      if (const auto problem = watches_.add(part, format)) {
        watches_.shorten(before);
        return error(whyWrong(part, *problem));
      }
    }
  if (watches_.rows().empty()) out_ << "nothing is watched; watch MW 10 HEX, A 0.0\n";
  printWatches();
}

void DebugSession::unwatch(std::string_view arguments) {
  const bool all = equalsIgnoreCase(arguments, "all");
  if (all) return watches_.shorten(0);
  const auto which = number(arguments);
  if (!which || *which == 0 || *which > watches_.rows().size())
    return error(fmt::format("'{}' is not watched; 'watch' lists the operands with their numbers",
                             arguments));
  watches_.remove(*which - 1);
}

void DebugSession::printWatches() {
  watches_.monitorNow();
  for (std::size_t i = 0; i < watches_.rows().size(); ++i)
    out_ << fmt::format("  {}: {} = {}\n", i + 1, watches_.rows()[i].operand.text,
                        watches_.text(i));
}

}  // namespace merker::app
