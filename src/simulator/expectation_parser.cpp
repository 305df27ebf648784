// What follows "expect" in a scenario.
#include "base/text.h"
#include "simulator/duration.h"
#include "simulator/expectations.h"
#include "simulator/line.h"
#include "simulator/relation.h"
#include "simulator/scenario_parser.h"

namespace merker::simulator {

using block::Relation;

static bool isBlank(char c) { return c == ' ' || c == '\t'; }

// Takes "for 5s" or "within 5s" off the end.
bool ScenarioParser::timing(Expectation& e, std::string_view& rest) {
  const auto place = findOutside(rest, [](std::string_view tail) {
    std::string_view words = tail;
    if (!isBlank(tail.front()) || (tail.size() > 1 && isBlank(tail[1]))) return false;
    const std::string_view word = takeWord(words);
    return equalsIgnoreCase(word, "for") || equalsIgnoreCase(word, "within");
  });
  if (place == std::string_view::npos) return true;
  std::string_view length = rest.substr(place);
  const bool during = equalsIgnoreCase(takeWord(length), "for");
  e.when = during ? Expectation::When::During : Expectation::When::Within;
  rest = trim(rest.substr(0, place));
  const auto duration = parseDuration(length);
  if (!duration) return fail(ProblemCode::P0953, length.empty() ? rest : length, length);
  e.duration = *duration;
  return true;
}

bool ScenarioParser::expectation(Expectation& e, std::string_view rest) {
  if (!timing(e, rest)) return false;
  std::string_view words = rest;
  std::string_view first = takeWord(words);
  if (equalsIgnoreCase(first, kPartner)) {
    e.partner = true;
    rest = words;
    first = takeWord(words);
  }
  if (equalsIgnoreCase(first, "diagnostics")) return diagnostics(e, words.empty() ? rest : words);
  const auto place =
      findOutside(rest, [](std::string_view tail) { return relationAt(tail) != nullptr; });
  if (place == std::string_view::npos)
    return fail(ProblemCode::P0952, rest, "a comparison (= <> < <= > >= ~=)");
  const RelationText* relation = relationAt(rest.substr(place));
  e.relation = relation->relation;
  const std::string_view left = trim(rest.substr(0, place));
  const std::string_view right = trim(rest.substr(place + relation->text.size()));
  if (equalsIgnoreCase(left, "mode")) return mode(e, rest, right);
  if (e.partner)
    return fail(ProblemCode::P0952, left.empty() ? rest : left,
                "mode, diagnostics contains, or an operand as partner.MW 10");
  std::string_view terminal = left;
  if (equalsIgnoreCase(takeWord(terminal), "terminal")) {
    e.what = Expectation::What::Terminal;
    return parseTerminal(
        terminal, right, e.terminal, [this](std::string_view text) { return at(text); }, problems_);
  }
  std::string_view field = left;
  if (takeStack(field, e.stack)) return stack(e, rest, field, right);
  std::string_view signal = left;
  if (equalsIgnoreCase(takeWord(signal), "plant")) {
    e.what = Expectation::What::Plant;
    return parsePlant(
        signal, right, e.plant, [this](std::string_view text) { return at(text); }, problems_);
  }
  std::string_view which = left;
  if (equalsIgnoreCase(takeWord(which), "LED")) return led(e, rest, which, right);
  return term(e.left, left, rest, "an operand") && term(e.right, right, rest, "a value");
}

bool ScenarioParser::mode(Expectation& e, std::string_view rest, std::string_view value) {
  e.what = Expectation::What::Mode;
  if (e.relation != Relation::Equal && e.relation != Relation::NotEqual)
    return fail(ProblemCode::P0952, rest, "mode = or mode <>");
  using controller::Mode;
  for (const Mode one : {Mode::Run, Mode::Stop, Mode::Startup, Mode::Halt}) {
    if (!equalsIgnoreCase(value, modeName(one))) continue;
    e.mode = one;
    return true;
  }
  return fail(ProblemCode::P0954, value.empty() ? rest : value, value);
}

bool ScenarioParser::led(Expectation& e, std::string_view rest, std::string_view which,
                         std::string_view light) {
  e.what = Expectation::What::Led;
  e.led = parseLed(which);
  const auto wanted = parseLight(light);
  if (e.relation != Relation::Equal && e.relation != Relation::NotEqual)
    return fail(ProblemCode::P0952, rest, "LED NAME = or LED NAME <>");
  if (e.led == nullptr)
    return fail(ProblemCode::P0952, which.empty() ? rest : which,
                "SF, BF, BATF, DC5V, FRCE, RUN or STOP");
  if (!wanted)
    return fail(ProblemCode::P0952, light.empty() ? rest : light,
                "off, on, slow (0.5 Hz) or fast (2 Hz)");
  e.light = *wanted;
  return true;
}

bool ScenarioParser::stack(Expectation& e, std::string_view rest, std::string_view field,
                           std::string_view value) {
  e.what = Expectation::What::Stack;
  e.stack.value = value;
  if (e.relation == Relation::About)
    return fail(ProblemCode::P0952, rest, "a comparison (= <> < <= > >=)");
  if (field.empty()) return fail(ProblemCode::P0952, rest, "a field, as ustack SAZ = 002A");
  return !value.empty() || fail(ProblemCode::P0952, rest, "a value, as 002A or PB 5");
}

bool ScenarioParser::diagnostics(Expectation& e, std::string_view rest) {
  e.what = Expectation::What::Diagnostics;
  std::string_view words = rest;
  const std::string_view contains = takeWord(words);
  if (!equalsIgnoreCase(contains, "contains"))
    return fail(ProblemCode::P0952, rest, "contains \"text\"");
  if (words.size() < 2 || words.front() != '"' || words.back() != '"')
    return fail(ProblemCode::P0952, words.empty() ? contains : words, "a text in quotation marks");
  e.words = words.substr(1, words.size() - 2);
  return true;
}

}  // namespace merker::simulator
