// What the checks of a program (//=) saw.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "block/check.h"
#include "interpreter/translate.h"

namespace merker::interpreter {

struct CheckRecord {
  const block::Check* check = nullptr;
  std::uint64_t reached = 0;
  std::vector<std::string> failures;  // the first few
};

class Recorder {
 public:
  static constexpr std::size_t kFailuresKept = 5;

  // Number of the new record. The check lives as long as the program.
  std::uint32_t add(const block::Check& check, const Translator& translator);
  // Looks at the state after the instruction; changes nothing.
  void evaluate(cpu::Machine& m, std::uint32_t first, std::uint32_t count);
  const std::deque<CheckRecord>& records() const { return records_; }
  void clear();

 private:
  struct Term {  // snippets of both sides; empty for constants and registers
    Translated left, right;
  };
  void evaluateOne(cpu::Machine& m, std::uint32_t number);

  std::deque<CheckRecord> records_;
  std::deque<std::deque<Term>> terms_;
};

}  // namespace merker::interpreter
