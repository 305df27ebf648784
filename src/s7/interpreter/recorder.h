// What the checks of a program (//=) saw.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "check/check_result.h"
#include "interpreter/translate.h"

namespace merker::interpreter {

using block::CheckFailure;

struct CheckSight {
  std::uint64_t reached = 0;
  std::vector<CheckFailure> failures;  // the first few
};

// A jump or block end leads away from its line or on to the next one. Behind LOOP or SPB a check
// usually speaks of the way on; it is judged by that if the program ever took it, and by the state
// after the jump otherwise.
struct CheckRecord {
  const block::Check* check = nullptr;
  CheckSight onward, away;
  const CheckSight& judged() const { return onward.reached ? onward : away; }
};

class Recorder {
 public:
  static constexpr std::size_t kFailuresKept = 5;

  // Number of the new record. The check lives as long as the program.
  std::uint32_t add(const block::Check& check, const Translator& translator);
  // Looks at the state after the instruction; changes nothing. `away`: it did not lead to the next
  // one.
  void evaluate(cpu::Machine& m, std::uint32_t first, std::uint32_t count, bool away);
  const std::deque<CheckRecord>& records() const { return records_; }
  void clear();

 private:
  struct Term {  // snippets of both sides; empty for constants and registers
    Translated left, right;
  };
  void evaluateOne(cpu::Machine& m, std::uint32_t number, bool away);

  std::deque<CheckRecord> records_;
  std::deque<std::deque<Term>> terms_;
};

}  // namespace merker::interpreter
