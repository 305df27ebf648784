// What a statement may be in its block, and the limits of its operand on this PLC.
#pragma once

#include <algorithm>
#include <set>

#include "mc5/range.h"
#include "step5/block_source.h"
#include "step5/statement.h"

namespace merker::step5 {

// Looks at the statements of one block in their order.
class StatementCheck {
 public:
  // `blocks`: those of the program.
  StatementCheck(const BlockSource& source, const std::set<mc5::BlockId>& blocks,
                 Problems& problems)
      : source_(source), blocks_(blocks), problems_(problems) {}

  // Supplementary operations and formal operands stand in function blocks only (S5-BLK-12).
  bool allowed(const Statement& s);
  // Limits of the PLC and what is possible but unwise.
  void inspect(const Statement& s);
  void constant(const mc5::Operand& operand, std::size_t offset, std::size_t length);
  void outside(const mc5::Operand& operand, const mc5::Range& range, std::size_t offset,
               std::size_t length);

 private:
  template <typename... Arguments>
  void add(ProblemCode code, std::size_t offset, std::size_t length,
           const Arguments&... arguments) {
    problems_.add(code, source_.file->position(offset, std::max<std::size_t>(length, 1)),
                  arguments...);
  }
  void exists(const Statement& s);

  const BlockSource& source_;
  const std::set<mc5::BlockId>& blocks_;
  Problems& problems_;
  bool processed_ = false;  // B DW or B MW stands before
};

}  // namespace merker::step5
