// What the checks of a program (//=) saw.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "check/check_record.h"
#include "interpreter/translate.h"

namespace merker::interpreter {

class Recorder {
 public:
  // Number of the new record.
  std::uint32_t add(const block::Check& check, const Translator& translator);
  // Looks at the state after the instruction; changes nothing. `away`: it did not lead to the next
  // one.
  void evaluate(cpu::Machine& m, std::uint32_t first, std::uint32_t count, bool away);
  const std::deque<block::CheckRecord>& records() const { return records_; }
  void clear();

 private:
  struct Term {  // snippets of both sides; empty for constants and registers
    Translated left, right;
  };
  void evaluateOne(cpu::Machine& m, std::uint32_t number, bool away);

  std::deque<block::CheckRecord> records_;
  std::deque<std::deque<Term>> terms_;
};

}  // namespace merker::interpreter
