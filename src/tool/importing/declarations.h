// The interfaces of a program's blocks with the names of their declarations.
#pragma once

#include <map>

#include "awl/block_text.h"
#include "importing/material.h"
#include "importing/report.h"
#include "step7/compiler.h"

namespace merker::importing {

// Whether both have the same sections and types, temporary data aside; names do not matter.
bool sameInterface(const block::Block& a, const block::Block& b);

bool isSystemFunction(BlockId id);
// One that the CPU has: it needs no source.
bool isOfTheCpu(BlockId id, const block::Program& library);

class Declarations {
 public:
  // `options` name library and symbols.
  Declarations(const std::vector<s7p::StoredBlock>& blocks, const step7::CompileOptions& options,
               Report& report);

  // The block with names and without code; null if it has no declaration that compiles.
  const block::Block* find(BlockId id) const;
  const awl::Texts& texts(BlockId id) const { return texts_.at(id); }
  // The library and all blocks declared here: what a source may call.
  const block::Program& callable() const { return callable_; }

 private:
  void declare(const s7p::StoredBlock& stored);
  void compile(const std::vector<s7p::StoredBlock>& blocks, const step7::CompileOptions& options);
  bool fits(const s7p::StoredBlock& stored) const;

  std::map<BlockId, awl::Texts> texts_;
  block::Program library_;  // with system functions of other CPUs that are stored
  block::Program declared_, callable_;
};

}  // namespace merker::importing
