#include "campaign/measure.h"

#include <array>
#include <charconv>

#include "base/text.h"
#include "check/relation.h"
#include "scenario/line.h"

namespace merker::campaign {
namespace {

using Kind = Measure::Kind;

constexpr std::string_view kWords =
    "max, min, mean, last or integral VALUE; count VALUE rising, falling or changes; time or when "
    "VALUE, also with = <> < <= > >= and a number; cycles; instructions";

struct Row {
  std::string_view first, last;  // words around the value
  Kind kind;
  bool condition = false;
};
constexpr std::array kRows{Row{"max", "", Kind::Max},
                           Row{"min", "", Kind::Min},
                           Row{"mean", "", Kind::Mean},
                           Row{"last", "", Kind::Last},
                           Row{"integral", "", Kind::Integral},
                           Row{"count", "rising", Kind::Rising},
                           Row{"count", "falling", Kind::Falling},
                           Row{"count", "changes", Kind::Changes},
                           Row{"time", "", Kind::Time, true},
                           Row{"when", "", Kind::When, true},
                           Row{"cycles", "", Kind::Cycles},
                           Row{"instructions", "", Kind::Instructions}};

// Takes the last word off, if it is this one.
bool takeLast(std::string_view& text, std::string_view word) {
  if (word.empty()) return true;
  const auto blank = text.find_last_of(" \t");
  if (blank == std::string_view::npos || !equalsIgnoreCase(text.substr(blank + 1), word))
    return false;
  text = trim(text.substr(0, blank));
  return true;
}

const Row* rowOf(std::string_view& text) {
  const std::string_view first = simulator::takeWord(text);
  for (const Row& row : kRows) {
    if (!equalsIgnoreCase(row.first, first) || !takeLast(text, row.last)) continue;
    const bool alone = row.kind == Kind::Cycles || row.kind == Kind::Instructions;
    return alone == text.empty() ? &row : nullptr;
  }
  return nullptr;
}

// "MW 10 >= 5" to the value; false if what stands behind the sign is no number.
bool takeCondition(std::string_view& text, Measure& measure) {
  const auto sign = simulator::findOutside(
      text, [](std::string_view rest) { return block::relationAt(rest) != nullptr; });
  if (sign == std::string_view::npos) return true;
  const block::RelationSign* relation = block::relationAt(text.substr(sign));
  const std::string_view digits = trim(text.substr(sign + relation->text.size()));
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), measure.limit);
  measure.relation = relation->relation;
  text = trim(text.substr(0, sign));
  return error == std::errc() && end == digits.data() + digits.size();
}

// plant.Vessel.LEVEL is the name that [campaign.vary] has for it.
std::string withBlank(std::string_view text) {
  if (!upper(text).starts_with("PLANT.")) return std::string(text);
  return "plant " + std::string(text.substr(6));
}

bool readSource(std::string_view text, const MeasureText& from, const compilation::Build& build,
                Measure& measure, Problems& problems) {
  if (text.size() > 2 && text.starts_with('|') && text.ends_with('|')) {
    measure.amount = true;
    text = trim(text.substr(1, text.size() - 2));
  }
  const std::size_t before = problems.size();
  const auto& hardware = build.project.hardware;
  const simulator::Resolver resolver = build.resolver();
  simulator::readWatchable(withBlank(text), from.position,
                           {resolver, build.project.plants, hardware ? &*hardware : nullptr},
                           measure.source, problems);
  // A timer counts by its status, as in a trace.
  for (address::Reference& operand : measure.source.operands)
    if (operand.operand.kind == address::OperandKind::Timer) operand.operand.width = Width::Bit;
  return problems.size() == before;
}

}  // namespace

std::optional<Measure> bindMeasure(const MeasureText& from, const compilation::Build& build,
                                   Problems& problems) {
  Measure measure;
  measure.name = from.name;
  measure.required = from.required;
  std::string_view text = trim(from.text);
  const Row* row = rowOf(text);
  if (row == nullptr || (row->condition && !takeCondition(text, measure))) {
    problems.add(ProblemCode::P0783, from.position, from.text, kWords);
    return std::nullopt;
  }
  measure.kind = row->kind;
  if (text.empty()) return measure;
  if (!readSource(text, from, build, measure, problems)) return std::nullopt;
  return measure;
}

}  // namespace merker::campaign
