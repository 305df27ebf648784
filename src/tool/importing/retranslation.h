// A source for each block that compiles to the stored bytes.
#pragma once

#include <map>

#include "importing/declarations.h"
#include "importing/material.h"
#include "importing/report.h"

namespace merker::importing {

enum class Origin : std::uint8_t { Stored, Disassembled, MachineCode };

struct BlockFile {
  BlockId id;
  std::string text;                     // AWL; empty: nothing but machine code
  std::vector<std::uint8_t> container;  // beside it, where the text does not give the bytes
  Origin origin = Origin::Disassembled;
};

class Retranslation {
 public:
  Retranslation(const Material& material, const step7::CompileOptions& options, Report& report);

  // Each source, before the blocks: what compiles to stored bytes is kept. True if any block of
  // it was used.
  bool offer(const TextFile& source);
  BlockFile write(const s7p::StoredBlock& stored);

 private:
  const s7p::StoredBlock* stored(BlockId id) const;
  std::string codeText(const s7p::StoredBlock& stored, const block::Block& declared,
                       awl::Form form) const;
  std::string declarationOf(const s7p::StoredBlock& stored, bool hidden) const;
  std::string code(const s7p::StoredBlock& stored, std::string& why);
  std::string data(const s7p::StoredBlock& stored);
  bool compilesTo(const s7p::StoredBlock& stored, const std::string& text, std::string& why) const;
  step7::Compilation compile(const std::string& name, const std::string& text) const;

  const Material& material_;
  step7::CompileOptions options_;
  Report& report_;
  Declarations declarations_;
  std::map<BlockId, std::string> kept_;
};

}  // namespace merker::importing
