// The cross reference of one block of STEP 7, instruction by instruction.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "monitor/call_statement.h"
#include "monitor/constant_bytes.h"
#include "monitor/opened_blocks.h"
#include "monitor/reference_rows.h"

namespace merker::monitor {

class Step7References {
 public:
  struct Surroundings {
    const block::Program& program;
    const source::SymbolTable& symbols;
    const CrossReferenceOptions& options;
    std::vector<CrossReference>& out;
  };
  Step7References(const block::Block& block, const Surroundings& around)
      : block_(block), around_(around), opened_(block), rows_(block, around.symbols, around.out) {}

  void run();

 private:
  void instruction(const mc7::Instruction& one);
  void beginStatement();
  void memory(const mc7::Instruction& one);
  void pointer(const mc7::Instruction& one);
  // The list behind a call of an FC or SFC; its bytes.
  std::size_t parameterList(const mc7::Instruction& call, std::span<const std::uint8_t> code);
  void parameter(const block::Variable& formal, std::uint32_t entry, const mc7::Instruction& call);
  void instanceParameters(const mc7::Instruction& call);
  void composite(const block::Variable& formal, Area area, BitAddress at,
                 const mc7::Instruction& call);
  void number(TypeCode type, std::uint32_t value, Use use, const mc7::Instruction& call);
  void range(const Descriptor& what, std::uint32_t bits, const std::string& length, Use use,
             const mc7::Instruction& call);

  void add(mc7::Operand key, std::int32_t db, Use use, const mc7::Instruction& one);
  void add(CrossReference row, Use use, const mc7::Instruction& one);
  const block::Block* called(const mc7::Operand& operand) const;
  std::uint32_t offset() const { return static_cast<std::uint32_t>(at_); }

  const block::Block& block_;
  Surroundings around_;
  OpenedBlocks opened_;
  ReferenceRows rows_;
  ConstantBytes bytes_;
  std::optional<CallStatement> call_;
  std::size_t at_ = 0;
  std::uint32_t statement_ = UINT32_MAX;
};

}  // namespace merker::monitor
