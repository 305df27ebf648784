// Program status of one block (S7-EDIT-21): the registers after each statement, as the last call of
// the block left them. Statements that this call did not reach show nothing. The end of a block
// gives its caller registers back (S7-INSTR-108); a statement that ends it shows what it found.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "monitor/kept_code.h"
#include "monitor/target.h"

namespace merker::monitor {

// Which calls are looked at; what is not given does not matter (call environment of STEP 7).
struct CallEnvironment {
  std::optional<BlockId> caller;
  std::optional<std::uint16_t> db, di;  // open when the block begins
  bool operator==(const CallEnvironment&) const = default;
};

// What somebody looks at: a block, in all or some of its calls.
struct StatusWish {
  BlockId block;
  CallEnvironment environment;
  bool operator==(const StatusWish&) const = default;
};

struct StatusRow {
  Statement statement;
  bool reached = false;
  std::uint32_t passes = 0;  // how often in this call: loops
  Registers after;
};

class ProgramStatus {
 public:
  explicit ProgramStatus(const BlockCode& code, CallEnvironment environment = {},
                         std::vector<CallValues> values = {});

  const BlockCode& code() const { return kept_.code(); }
  StatusWish wish() const { return {code().id(), environment_}; }
  std::uint64_t calls() const { return calls_; }            // seen so far
  std::uint64_t otherCalls() const { return otherCalls_; }  // not in this environment
  // Instance data blocks of the calls seen so far, in any environment; of a function block of S7.
  const std::set<std::uint16_t>& instances() const { return instances_; }
  // That of the call that the rows are of.
  std::optional<std::uint16_t> instance() const { return instance_; }
  // In the order of the code.
  std::vector<StatusRow> rows() const;
  // The row of the statement at `offset`, if the last call reached it.
  const StatusRow* at(std::uint32_t offset) const;

  // Of the CALLs of the block, with the values of their operands.
  const std::vector<CallValues>& callValues() const { return callValues_; }

  // From the probe of this block: an instruction is next, it is executed now, it is done.
  void arrived(const Spot& spot);
  void before(const Spot& spot);
  void after(const Spot& spot);

 private:
  struct Open {  // an instruction that opened a block and has not come back
    std::size_t frames;
    std::uint32_t offset;
    Registers found;
  };
  bool wanted(const Registers& registers, const Spot& spot) const;
  void begin(const Spot& spot);
  void record(const Registers& found, const Registers& left, std::uint32_t offset);
  void recordOne(const Registers& registers, std::uint32_t offset);

  KeptCode kept_;  // a download may take the original away
  CallEnvironment environment_;
  bool recording_ = false;
  std::uint64_t calls_ = 0, otherCalls_ = 0;
  std::set<std::uint16_t> instances_;
  std::optional<std::uint16_t> instance_;
  std::size_t running_ = 0;  // depth of the call that is under way, 0 = none
  void readValues(const Spot& spot, bool behind);

  std::vector<Open> open_;
  std::vector<CallValues> callValues_;       // ascending by offset
  std::map<std::uint32_t, StatusRow> rows_;  // by the beginning of the statement
};

}  // namespace merker::monitor
