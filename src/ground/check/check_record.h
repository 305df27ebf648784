// What an engine writes down about one check of the program that it runs.
#pragma once

#include <optional>
#include <string>

#include "check/check_result.h"
#include "check/relation.h"

namespace merker::block {

// What is wrong with a term, "is W#16#7FFF"; nothing if it holds. A side without a value cannot be
// read. `shown` writes a value in the notation of the family.
template <typename ToReal, typename Shown>
std::optional<std::string> judge(const CheckTerm& term, std::optional<std::uint32_t> left,
                                 std::optional<std::uint32_t> right, ToReal toReal, Shown shown) {
  if (!left || !right) return "the operand cannot be read here";
  if (holds(*left, term.relation, *right, toReal)) return std::nullopt;
  return "is " + shown(*left, term);
}

// A jump or block end leads away from its line or on to the next one. Behind LOOP or SPB a check
// usually speaks of the way on; it is judged by that if the program ever took it, and by the state
// after the jump otherwise.
class CheckRecord {
 public:
  static constexpr std::size_t kFailuresKept = 5;

  // The check lives as long as the program.
  explicit CheckRecord(const Check& check)
      : onward_{.check = &check, .failures = {}}, away_{.check = &check, .failures = {}} {}

  // The instruction has run and led to the next one or away. `wrong(i)`: what is wrong with the
  // i-th term, see judge(); it changes nothing.
  template <typename Wrong>
  void evaluate(Instant now, bool away, Wrong wrong) {
    CheckResult& seen = away ? away_ : onward_;
    ++seen.reached;
    const auto& terms = seen.check->terms;
    for (std::size_t i = 0; i < terms.size() && seen.failures.size() < kFailuresKept; ++i)
      if (const auto text = wrong(i)) seen.failures.push_back({now, terms[i].text + ": " + *text});
  }

  const Check& check() const { return *onward_.check; }
  const CheckResult& result() const { return onward_.reached > 0 ? onward_ : away_; }

 private:
  CheckResult onward_, away_;
};

}  // namespace merker::block
