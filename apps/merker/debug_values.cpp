// Commands of `merker debug` that show and change values.
#include <fmt/format.h>

#include <ostream>

#include "base/text.h"
#include "debug_session.h"
#include "simulator/line.h"

namespace merker::app {
namespace {

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

// #name: of the running block.
void DebugSession::printOne(std::string_view text) {
  if (text.starts_with('#')) {
    for (const monitor::FrameVariable& one : monitor_.variables(0))
      if (equalsIgnoreCase(one.name, text.substr(1))) {
        out_ << fmt::format("{} = {}\n", text, one.value.value_or("-"));
        return;
      }
    return error(fmt::format("the running block has no variable '{}'; 'locals' lists them", text));
  }
  const monitor::DisplayFormat format = takeFormat(text);
  const auto value = monitor_.read(text, format);
  if (!value) return error(value.error());
  out_ << fmt::format("{} = {}\n", text, *value);
}

void DebugSession::print(std::string_view arguments) {
  if (arguments.empty()) return error("an operand is expected: print MW 10 HEX, A 0.0");
  for (const std::string_view part : simulator::splitList(arguments)) printOne(part);
}

void DebugSession::assign(std::string_view arguments, const Setter& setter) {
  for (const std::string_view part : simulator::splitList(arguments)) {
    const std::size_t sign =
        simulator::findOutside(part, [](std::string_view rest) { return rest.front() == '='; });
    if (sign == std::string_view::npos)
      return error(fmt::format("'{}' is not OPERAND = VALUE", part));
    if (const auto problem = setter(trim(part.substr(0, sign)), trim(part.substr(sign + 1))))
      return error(*problem);
  }
}

void DebugSession::set(std::string_view arguments) {
  assign(arguments, [this](std::string_view operand, std::string_view value) {
    monitor::DisplayFormat format = takeFormat(value);
    return monitor_.write(operand, value, format);
  });
}

void DebugSession::force(std::string_view arguments) {
  if (arguments.empty()) {
    for (const monitor::Forced& one : monitor_.forces())
      out_ << fmt::format("{} = {}\n", one.operand.text,
                          monitor::show(one.operand, one.value, monitor::DisplayFormat::Automatic));
    if (monitor_.forces().empty()) out_ << "no forces\n";
    return;
  }
  assign(arguments, [this](std::string_view operand, std::string_view value) {
    return monitor_.force(operand, value);
  });
}

void DebugSession::unforce(std::string_view arguments) {
  if (arguments.empty() || equalsIgnoreCase(arguments, "all")) return monitor_.unforceAll();
  for (const std::string_view part : simulator::splitList(arguments))
    if (const auto problem = monitor_.unforce(part)) return error(*problem);
}

void DebugSession::watch(std::string_view arguments) {
  if (!arguments.empty())
    for (std::string_view part : simulator::splitList(arguments)) {
      const monitor::DisplayFormat format = takeFormat(part);
      if (const auto problem = watches_.add(part, format)) return error(*problem);
    }
  if (watches_.rows().empty()) out_ << "nothing is watched; watch MW 10 HEX, A 0.0\n";
  printWatches();
}

void DebugSession::unwatch(std::string_view arguments) {
  const bool all = equalsIgnoreCase(arguments, "all");
  const std::string text(arguments);
  char* end = nullptr;
  const std::size_t number = all ? 1 : std::strtoull(text.c_str(), &end, 10);
  if (!all && (*end != 0 || number == 0 || number > watches_.rows().size()))
    return error("'" + text + "' is not watched; 'watch' lists what is, with numbers");
  while (all && !watches_.rows().empty()) watches_.remove(0);
  if (!all) watches_.remove(number - 1);
}

void DebugSession::printWatches() {
  watches_.monitorNow();
  for (std::size_t i = 0; i < watches_.rows().size(); ++i)
    out_ << fmt::format("  {}: {} = {}\n", i + 1, watches_.rows()[i].operand.text,
                        watches_.text(i));
}

}  // namespace merker::app
