// Watches a program run: evaluates its checks (//=) and counts its instructions (coverage). The
// program does not notice.
#pragma once

#include <map>
#include <vector>

#include "check/check_record.h"
#include "mc5/block.h"
#include "softplc/processor.h"

namespace merker::sinumerik {

using block::CheckFailure;
using block::CheckResult;

// How often each instruction ran: by block and word of its code.
using Executed = std::map<mc5::BlockId, std::map<std::uint32_t, std::uint64_t>>;

class Recorder {
 public:
  // The program stays where it is as long as the recorder lives.
  Recorder(const mc5::Program& program, bool coverage);

  bool active() const { return coverage_ || !records_.empty(); }
  void beforeStep(const Machine& machine);
  void afterStep(Processor& processor, Outcome outcome);
  // Instructions with checks, by word of segment 5.
  std::vector<bool> watched(const BlockMemory& blocks);
  void forgetCalls() { calls_.clear(); }  // the levels are gone

  std::vector<CheckResult> results() const;
  const Executed& executed() const { return executed_; }

 private:
  struct Record {
    const mc5::Block* block = nullptr;
    block::CheckRecord check;
  };
  // An instruction that runs: where, and how deep its block lies.
  struct Place {
    std::size_t level = 0, depth = 0;
    mc5::BlockId block;
    std::uint32_t start = 0, word = 0;
    std::uint32_t last = 0;  // behind B: the instruction that was processed
  };

  void attach(const BlockMemory& blocks);
  void attachTo(const mc5::Block& block, const BlockMemory& blocks);
  void count(const Place& place, std::uint32_t word);
  void evaluate(Processor& processor, const Place& place, bool away);
  void evaluateAt(Processor& processor, std::uint32_t word, bool away);
  void returned(Processor& processor);

  const mc5::Program& program_;
  const bool coverage_;
  std::vector<Record> records_;
  std::multimap<std::uint32_t, std::size_t> byWord_;  // word of segment 5, number of the record
  std::uint64_t version_ = ~std::uint64_t{0};         // of the block memory that byWord_ knows
  std::vector<Place> calls_;                          // whose blocks have not returned yet
  Place now_;
  Executed executed_;
};

}  // namespace merker::sinumerik
