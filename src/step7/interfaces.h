// Resolves declarations to interfaces with addresses: UDTs, FBs and instance DBs refer to each
// other, so each is resolved when it is first needed; a circle is a problem. Second pass of the
// compiler.
#pragma once

#include <map>
#include <vector>

#include "step7/block_source.h"
#include "step7/compiler.h"

namespace merker::step7 {

class Interfaces {
 public:
  Interfaces(std::vector<BlockSource>& sources, const CompileOptions& options, Problems& problems);

  // Resolves all blocks; afterwards `program()` holds them without code.
  void resolveAll();
  // Null if there is no such block, neither in the sources nor in the CPU.
  const block::Block* find(BlockId id);
  block::Program& program() { return program_; }
  // The FB or SFB as a structure: what an instance of it looks like.
  block::TypePtr instanceType(BlockId id);
  // A DB or UDT whose structure could not be read: what it contains is not known.
  bool unknown(BlockId id) const;

 private:
  enum class State : std::uint8_t { Open, Busy, Done };
  struct Entry {
    BlockSource* source = nullptr;
    State state = State::Open;
    bool unknown = false;
  };

  const block::Block* resolve(BlockId id);
  // Neither in the sources nor in the CPU.
  void missing(const Position& place, BlockId id);
  bool busy(BlockId id) const;  // its declarations are being resolved: it contains itself
  void resolveCode(BlockSource& source, block::Block& result);
  void resolveData(BlockSource& source, block::Block& result);
  void layOutSections(BlockSource& source, block::Block& result);
  bool hasStartInformation(const std::vector<block::Variable>& temps) const;
  void dataBlockOf(BlockSource& source, const block::Type& type, block::Block& result);
  void assignments(BlockSource& source, const std::vector<block::Variable>& variables,
                   block::Block& result);
  void checkInitial(const BlockSource& source, const VariableSyntax& variable);
  void checkNoInitials(const BlockSource& source, const TypeSyntax& type);
  block::TypePtr type(const BlockSource& source, const TypeSyntax& syntax, block::Section section);
  block::TypePtr blockType(const BlockSource& source, const TypeSyntax& syntax, BlockId id,
                           block::Section section);
  block::TypePtr structure(const BlockSource& source, const TypeSyntax& syntax);
  block::Variable variable(const BlockSource& source, const VariableSyntax& syntax);
  void checkDuplicates(const BlockSource& source, const std::vector<VariableSyntax>& variables);
  Position at(const BlockSource& source, std::size_t begin, std::size_t end) const {
    return source.file->position(begin, std::max(end, begin + 1) - begin);
  }

  const CompileOptions& options_;
  Problems& problems_;
  std::map<BlockId, Entry> entries_;
  block::Program program_;
  int depth_ = 0;
  std::map<BlockId, block::TypePtr> instanceTypes_;
};

}  // namespace merker::step7
