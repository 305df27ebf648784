// Collects the machine code of one block: instructions, lines, networks, jumps to labels.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "block/block.h"
#include "mc7/instruction.h"
#include "source/source_file.h"

namespace merker::step7 {

class CodeBuilder {
 public:
  // Appends an instruction; false if there is no such machine instruction.
  [[nodiscard]] bool emit(mc7::Operation operation, const mc7::Operand& operand = {});
  // A jump whose distance follows from the label later.
  void jump(mc7::Operation operation, std::string label, Position position);
  // A distributor: its entries are the SPA that follow (S7-INSTR-127).
  void jumpList(std::string label, Position position);
  bool label(std::string name, Position position,
             Problems& problems);  // false if it exists already
  // Entry of a parameter list behind a call.
  void parameterEntry(std::uint32_t pointer);
  void line(std::uint32_t line, std::uint32_t column);
  void network(std::string title);
  void networkTitle(std::string title);

  // Puts the distances in; problems for labels that are missing or too far.
  void resolveJumps(Problems& problems);

  std::uint32_t offset() const { return static_cast<std::uint32_t>(code_.size()); }
  std::uint32_t lastInstruction() const { return last_; }
  const std::vector<std::uint8_t>& code() const { return code_; }
  std::vector<block::Check>& checks() { return checks_; }
  // The labels of the block: one name for each place that jumps lead to, in their order.
  void moveInto(block::Block& block);

 private:
  struct Fixup {
    std::uint32_t offset;
    std::string label;
    Position position;
    bool list;
  };
  std::vector<std::string> jumpTargets() const;
  void patch(const Fixup& fixup, std::uint32_t target, Problems& problems);

  std::vector<std::uint8_t> code_;
  std::uint32_t last_ = 0;
  std::vector<block::LineEntry> lines_;
  std::vector<block::Network> networks_;
  std::map<std::string, std::uint32_t> labels_;
  std::vector<Fixup> fixups_;
  std::vector<block::Check> checks_;
};

}  // namespace merker::step7
