#include "scenario/junit.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <ostream>

#include "scenario/duration.h"

namespace merker::simulator {
namespace {

// XML 1.0 has no control characters, not even escaped.
std::string escape(std::string_view text) {
  std::string out;
  for (char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\n':
        out += "&#10;";
        break;
      default:
        out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return out;
}

std::string seconds(Instant time) { return formatSeconds(time.ns, 6); }

void writeCase(const TestResult& result, std::ostream& out) {
  out << fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{}\"", escape(result.file),
                     escape(result.name), seconds(result.end));
  if (result.passed()) {
    out << "/>\n";
    return;
  }
  out << ">\n";
  for (const Failure& failure : result.failures)
    out << fmt::format("      <failure message=\"{}\">{}</failure>\n", escape(failure.message),
                       escape(describe(failure)));
  out << "    </testcase>\n";
}

using Suite = std::vector<const TestResult*>;

auto failed(const Suite& suite) {
  return std::count_if(suite.begin(), suite.end(),
                       [](const TestResult* r) { return !r->passed(); });
}

void writeSuite(const std::string& file, const Suite& suite, std::ostream& out) {
  std::int64_t ns = 0;
  for (const TestResult* result : suite) ns += result->end.ns;
  out << fmt::format(
      "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" time=\"{}\">\n",
      escape(file), suite.size(), failed(suite), seconds({ns}));
  for (const TestResult* result : suite) writeCase(*result, out);
  out << "  </testsuite>\n";
}

}  // namespace

std::string describe(const Failure& failure) {
  const Position& p = failure.position;
  const std::string place = p.line == 0 ? p.file : fmt::format("{}:{}", p.file, p.line);
  return fmt::format("{}: at {}: {}", place, formatTime(failure.time), failure.message);
}

void writeJunit(const std::vector<TestResult>& results, std::ostream& out) {
  std::map<std::string, Suite> suites;
  Suite all;
  for (const TestResult& result : results) {
    suites[result.file].push_back(&result);
    all.push_back(&result);
  }
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  out << fmt::format("<testsuites tests=\"{}\" failures=\"{}\">\n", all.size(), failed(all));
  for (const auto& [file, suite] : suites) writeSuite(file, suite, out);
  out << "</testsuites>\n";
}

}  // namespace merker::simulator
