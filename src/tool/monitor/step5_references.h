// The cross reference of one block of STEP 5, instruction by instruction.
#pragma once

#include <map>
#include <set>

#include "monitor/reference_rows.h"
#include "monitor/step5_code.h"

namespace merker::monitor {

// What function blocks do with the actual operands of their calls (S5-FB-15 … -17).
class FormalUses {
 public:
  struct Of {
    std::map<std::uint32_t, Use> words;  // by the parameter's word of the list
    bool opens = false;                  // it has a data block of its own
  };
  const Of& of(const mc5::Block& block);

 private:
  std::map<const mc5::Block*, Of> blocks_;
};

class Step5References {
 public:
  struct Surroundings {
    const mc5::Program& program;
    const source::SymbolTable& symbols;
    FormalUses& formals;
    std::vector<CrossReference>& out;
  };
  Step5References(const mc5::Block& block, const Surroundings& around);

  void run();

 private:
  void findTargets(const std::vector<Step5Instruction>& code);
  void instruction(const Step5Instruction& one);
  void open(const mc5::Instruction& one, bool substituted);
  void actualOperands(const Step5Instruction& call);
  void formal(const mc5::Instruction& one);
  void add(const mc5::Operand& operand, Use use, std::int32_t db, const mc5::Instruction& one);
  std::string text(const mc5::Instruction& one) const;

  const mc5::Block& block_;
  Surroundings around_;
  ReferenceRows rows_;
  std::map<std::uint32_t, std::string> names_;  // of formal operands, by word of the list
  std::set<std::uint32_t> targets_;             // instructions that are jumped to
  bool anyTarget_ = false;                      // B stands before a jump
  bool substitutes_ = false;                    // B stands before this instruction
  std::int32_t db_ = -1;                        // the open data block; -1: not known
};

}  // namespace merker::monitor
