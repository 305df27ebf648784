// The words an expectation begins with; one that begins with none of them speaks of an operand.
#include "base/text.h"
#include "check/relation.h"
#include "scenario/expectation.h"

namespace merker::simulator {
namespace {

struct ExpectationWord {
  std::string_view word;
  bool (*parse)(const StepLine&, const Claim&, AnyExpectation&);
  enum class Of : std::uint8_t { Own, Both } of = Of::Own;  // Both: also of the coupled control
  enum class Form : std::uint8_t { Comparison, Words } form = Form::Comparison;
};
using Of = ExpectationWord::Of;
using Form = ExpectationWord::Form;

template <IsExpectation E>
bool parse(const StepLine& line, const Claim& claim, AnyExpectation& expectation) {
  return expectation.emplace<E>().parse(line, claim);
}

constexpr ExpectationWord kExpectations[] = {
    {"diagnostics", parse<expectations::Diagnostics>, Of::Both, Form::Words},
    {"serial", parse<expectations::Serial>, Of::Own, Form::Words},
    {"mode", parse<expectations::Mode>, Of::Both},
    {"terminal", parse<expectations::Terminal>},
    {"ustack", parse<expectations::Stack>},
    {"bstack", parse<expectations::Stack>},
    {"plant", parse<expectations::Plant>},
    {"LED", parse<expectations::Led>},
};

// The row whose word the claim's subject begins with; that is taken off. Null if there is none.
const ExpectationWord* takeExpectationWord(Claim& claim, Form form) {
  std::string_view rest = claim.subject;
  const std::string_view first = takeWord(rest);
  for (const ExpectationWord& row : kExpectations) {
    if (row.form != form || !equalsIgnoreCase(row.word, first)) continue;
    claim.word = first;
    claim.subject = rest;
    return &row;
  }
  return nullptr;
}

// "LED RUN = on" to "LED RUN", = and "on".
bool cut(const StepLine& line, Claim& claim) {
  const auto place = findOutside(
      claim.whole, [](std::string_view tail) { return block::relationAt(tail) != nullptr; });
  if (place == std::string_view::npos)
    return line.fail(ProblemCode::P0952, claim.whole, "a comparison (= <> < <= > >= ~=)");
  const auto* const relation = block::relationAt(claim.whole.substr(place));
  claim.relation = relation->relation;
  claim.subject = trim(claim.whole.substr(0, place));
  claim.value = trim(claim.whole.substr(place + relation->text.size()));
  return true;
}

}  // namespace

bool parseExpectation(const StepLine& line, std::string_view text, bool ofPartner,
                      AnyExpectation& expectation) {
  Claim claim{text, {}, text, {}, {}};
  if (const ExpectationWord* const row = takeExpectationWord(claim, Form::Words))
    return row->parse(line, claim, expectation);
  if (!cut(line, claim)) return false;
  const std::string_view left = claim.subject;
  const ExpectationWord* const row = takeExpectationWord(claim, Form::Comparison);
  if (ofPartner && (row == nullptr || row->of != Of::Both))
    return line.fail(ProblemCode::P0952, left.empty() ? text : left,
                     "mode, diagnostics contains, or an operand: partner.MW 10");
  if (row != nullptr) return row->parse(line, claim, expectation);
  return namesAxis(claim.subject) ? parse<expectations::Axis>(line, claim, expectation)
                                  : parse<expectations::Values>(line, claim, expectation);
}

}  // namespace merker::simulator
