#include "campaign/report.h"

#include <fmt/format.h>

#include <cmath>
#include <ostream>

#include "scenario/junit.h"

namespace merker::campaign {
namespace {

// RFC 4180.
std::string field(std::string_view text) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

void writeHeader(const Definition& definition, std::ostream& out) {
  out << "run,id";
  for (const Parameter& one : definition.parameters) out << ',' << field(one.name);
  out << ",seed,passed,message,seconds,cycles";
  for (const MeasureText& one : definition.measures) out << ',' << one.name;
  out << "\r\n";
}

void writeLine(const Choice& choice, const std::string& id, const Outcome& outcome,
               std::ostream& out) {
  out << choice.number + 1 << ',' << id;
  for (const Value& value : choice.values) out << ',' << field(value.text);
  out << fmt::format(",{},{},{},{},{}", choice.seed, outcome.passed ? 1 : 0, field(outcome.message),
                     outcome.seconds, outcome.cycles);
  for (const auto& measure : outcome.measures)
    out << ',' << (measure ? fmt::format("{}", *measure) : std::string());
  out << "\r\n";
}

simulator::TestResult testOf(const Definition& definition, const Choice& choice,
                             const Outcome& outcome) {
  simulator::TestResult result{
      definition.name, describe(definition, choice), {std::llround(outcome.seconds * 1e9)}, {}};
  if (!outcome.passed)
    result.failures.push_back({Position{definition.name}, result.end, outcome.message});
  return result;
}

}  // namespace

std::optional<Problem> writeCsv(const Plan& plan, const Shard& shard, Results& results,
                                std::ostream& out) {
  writeHeader(plan.definition(), out);
  const auto summary =
      eachOutcome(plan, shard, results,
                  [&](const Choice& choice, const std::string& id, const Outcome& outcome) {
                    writeLine(choice, id, outcome, out);
                  });
  return summary ? std::nullopt : std::optional(summary.error());
}

std::optional<Problem> writeJunit(const Plan& plan, const Shard& shard, Results& results,
                                  std::ostream& out) {
  std::vector<simulator::TestResult> tests;
  const auto summary = eachOutcome(
      plan, shard, results, [&](const Choice& choice, const std::string&, const Outcome& outcome) {
        tests.push_back(testOf(plan.definition(), choice, outcome));
      });
  if (!summary) return summary.error();
  simulator::writeJunit(tests, out);
  return std::nullopt;
}

}  // namespace merker::campaign
