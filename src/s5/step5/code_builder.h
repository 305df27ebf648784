// Machine code of one block while it is written: words, lines, networks, labels and jumps.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mc5/block.h"
#include "mc5/instruction.h"
#include "step5/block_source.h"

namespace merker::step5 {

class CodeBuilder {
 public:
  CodeBuilder(const BlockSource& source, mc5::Block& block, Problems& problems);

  void instruction(const mc5::Instruction& instruction, std::size_t offset);
  void word(std::uint16_t word) { block_.words.push_back(word); }
  // A jump whose label comes later; the label's place in the file for its problems.
  void jump(const mc5::Instruction& instruction, const std::string& label, std::size_t offset,
            std::size_t labelOffset);
  void label(const std::string& name, std::size_t offset);
  // NETZWERK and SEGMENT.
  void network(const std::string& title);
  // ***: the next statement begins a network if no NETZWERK stands before it.
  void endNetwork();
  // Fills in the distances and looks at what is still open.
  void finish();

  std::uint32_t next() const { return static_cast<std::uint32_t>(block_.words.size()); }
  // Word of the last instruction of the source; nothing before the first.
  std::optional<std::uint32_t> last() const { return last_; }

 private:
  struct Label {
    std::uint32_t word = 0;
    std::size_t network = 0;
  };
  struct Jump {
    mc5::Instruction instruction;
    std::string label;
    std::uint32_t word = 0;
    std::size_t network = 0, offset = 0;
  };

  void bracket(const mc5::Instruction& instruction, std::size_t offset);
  void fillIn(const Jump& jump);
  void closeBrackets();
  void begin(const std::string& title);
  void beforeCode();
  Position at(std::size_t offset, std::size_t length) const;

  const BlockSource& source_;
  mc5::Block& block_;
  Problems& problems_;
  std::map<std::string, Label> labels_;
  std::vector<Jump> jumps_;
  std::size_t network_ = 0;
  bool ends_ = false;                  // behind ***
  bool separated_ = false;             // behind a BLD 255 of the source
  std::vector<std::size_t> brackets_;  // where the open ones stand in the file
  std::optional<std::uint32_t> last_;
};

}  // namespace merker::step5
