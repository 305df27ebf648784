#include "itcp/cpu_page.h"

#include <fmt/format.h>

#include "itcp/escape.h"

namespace merker::itcp {
namespace {

constexpr std::string_view kHead =
    "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
    "<meta http-equiv=\"refresh\" content=\"2\">\n<title>CPU</title>\n<style>\n"
    "body { font: 15px sans-serif; margin: 2em; } th { text-align: left; }\n"
    "td, th { padding: 0.15em 1em 0.15em 0; vertical-align: top; }\n"
    ".led { display: inline-block; width: 0.9em; height: 0.9em; border: 1px solid #888; }\n"
    "</style>\n</head>\n<body>\n<h1>CPU</h1>\n";

std::string html(std::string_view text) { return escaped(text, Escape::Html); }
std::string json(std::string_view text) {
  return fmt::format("\"{}\"", escaped(text, Escape::Json));
}

std::string row(std::string_view name, std::string_view value) {
  return value.empty() ? std::string()
                       : fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", name, html(value));
}

std::string ledRows(const CpuFacts& facts) {
  std::string rows;
  for (const CpuFacts::Led& led : facts.leds)
    rows += fmt::format(
        "<tr><th>{}</th><td id=\"{}\"><span class=\"led\" style=\"background: {}\"></span> "
        "{}</td></tr>\n",
        led.name, led.name, led.light == cpu::Light::Off ? "#ddd" : led.colour, nameOf(led.light));
  return rows;
}

std::string entryRows(const CpuFacts& facts) {
  std::string rows;
  for (const CpuFacts::Entry& entry : facts.entries)
    rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", html(entry.clock),
                        html(entry.event), html(entry.text));
  return rows;
}

}  // namespace

std::string cpuPage(const CpuFacts& facts) {
  std::string page(kHead);
  page += "<table>\n" + row("Module", facts.model) + row("Order number", facts.orderNumber) +
          row("Operating mode", facts.mode) + row("Cause of STOP", facts.stopReason) +
          row("Time of day", facts.clock) +
          row("Cycle time", fmt::format("{} ms, shortest {} ms, longest {} ms", facts.lastCycle,
                                        facts.shortestCycle, facts.longestCycle)) +
          ledRows(facts) + "</table>\n";
  if (!facts.entries.empty())
    page += "<h2>Diagnostic buffer</h2>\n<table>\n" + entryRows(facts) + "</table>\n";
  return page + "</body>\n</html>\n";
}

std::string cpuJson(const CpuFacts& facts) {
  std::string leds, entries;
  for (const CpuFacts::Led& led : facts.leds)
    leds +=
        fmt::format("{}{}: {}", leds.empty() ? "" : ", ", json(led.name), json(nameOf(led.light)));
  for (const CpuFacts::Entry& entry : facts.entries)
    entries +=
        fmt::format("{}{{\"time\": {}, \"event\": {}, \"text\": {}}}", entries.empty() ? "" : ", ",
                    json(entry.clock), json(entry.event), json(entry.text));
  return fmt::format(
      "{{\"model\": {}, \"orderNumber\": {}, \"mode\": {}, \"stopReason\": {}, \"clock\": {}, "
      "\"cycles\": {}, \"cycle\": {}, \"leds\": {{{}}}, \"diagnostics\": [{}]}}\n",
      json(facts.model), json(facts.orderNumber), json(facts.mode), json(facts.stopReason),
      json(facts.clock), facts.cycles, facts.lastCycle, leds, entries);
}

}  // namespace merker::itcp
