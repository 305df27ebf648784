// Resolves declarations to interfaces with addresses: UDTs, FBs and instance DBs refer to each
// other, so each is resolved when it is first needed; a circle is a problem. Second pass of the
// compiler.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "step7/block_names.h"
#include "step7/block_source.h"
#include "step7/compiler.h"
#include "step7/member_index.h"
#include "step7/structure_numbers.h"

namespace merker::step7 {

// The variables of a data block as a structure.
block::TypePtr dataTypeOf(const block::Block& db);

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
  // Of a block that find() gave, or that stands in program().
  const BlockNames& names(const block::Block& block);
  // A DB or UDT whose structure could not be read: what it contains is not known.
  bool unknown(BlockId id) const;
  // A data block as a structure, unknown where its structure is.
  block::TypePtr dataType(const block::Block& db);
  MemberIndex& members() { return members_; }
  StructureNumbers& structures() { return structures_; }

 private:
  enum class State : std::uint8_t { Open, Busy, Done };
  struct Entry {
    BlockSource* source = nullptr;
    State state = State::Open;
    bool unknown = false;
  };

  const block::Block* resolve(BlockId id);
  // Neither in the sources nor in the CPU; reported once for each block.
  void missing(const BlockSource& source, const Position& place, BlockId id);
  bool busy(BlockId id) const;  // its declarations are being resolved: it contains itself
  void resolveCode(BlockSource& source, block::Block& result);
  void resolveData(BlockSource& source, block::Block& result);
  void layOutSections(BlockSource& source, block::Block& result);
  bool hasStartInformation(const std::vector<block::Variable>& temps) const;
  void dataBlockOf(BlockSource& source, const block::TypePtr& type, block::Block& result);
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
  block::TypePtr typeOf(const BlockSource& source, const VariableSyntax& syntax);
  // How much a walk over all the parts of a type sees, and how deep it goes.
  struct Extent {
    std::uint64_t parts = 1;
    int depth = 0;
  };
  Extent extent(const block::TypePtr& type);
  // The type, or the unknown one and a problem if it is larger or deeper than any that exists.
  block::TypePtr limited(block::TypePtr type, const Position& place);
  // False, and a problem the first time, if all blocks together have more than this of it.
  bool take(std::uint64_t& used, std::uint64_t more, std::uint64_t limit, std::string_view what,
            const Position& place);
  Position at(const BlockSource& source, std::size_t begin, std::size_t end) const {
    return source.file->position(begin, std::max(end, begin + 1) - begin);
  }

  const CompileOptions& options_;
  Problems& problems_;
  std::map<BlockId, Entry> entries_;
  block::Program program_;
  int depth_ = 0;
  std::map<BlockId, block::TypePtr> instanceTypes_;
  std::map<const TypeSyntax*, block::TypePtr> types_;  // of declarations with several names
  std::map<block::TypePtr, Extent> extents_;
  std::map<BlockId, block::TypePtr> dataTypes_;
  MemberIndex members_;
  StructureNumbers structures_;
  std::uint64_t dataBytes_ = 0, variables_ = 0, components_ = 0, initialBytes_ = 0;
  std::map<BlockId, BlockNames> names_;
  std::set<std::pair<BlockId, std::string>> missing_;  // what is reported of a block
};

}  // namespace merker::step7
