// A block folder: SUBBLK.DBF and its memo, read one block at a time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "archive/tree.h"
#include "base/code_page.h"
#include "block/block.h"
#include "s7p/comments.h"
#include "s7p/dbase.h"
#include "s7p/fault.h"
#include "s7p/variable_table.h"

namespace merker::s7p {

struct StoredBlock {
  // Machine code or actual values, interface without names, attributes. An SFC or SFB: its
  // interface only.
  block::Block block;
  std::string declaration;  // as the editor shows it; empty if there is none
  BlockComments comments;
  bool damaged = false;  // code or values are missing
  std::string created;   // time stamp of the code: "2005-03-01 08:00:00.000"
};

class Folder {
 public:
  Folder(const archive::Tree& tree, const std::string& folder, const CodePage& page,
         Faults& faults);

  // Each number of a kind once: the linked row before one that is not.
  const std::vector<BlockId>& blocks() const { return ids_; }
  std::optional<StoredBlock> read(BlockId id);
  std::vector<VariableTable> variableTables() const;

 private:
  // A row: what is needed to find its parts in the memo.
  struct Row {
    std::uint32_t object = 0, type = 0, language = 0, attribute = 0, password = 0, local = 0;
    std::uint32_t reserved = 0;  // AGRESERVED: 0 for CODE_VERSION1, else 1
    std::uint32_t checksum = 0;
    std::uint16_t number = 0;
    std::uint8_t version = 0;
    std::uint32_t code = 0, codeLength = 0, interface = 0, interfaceLength = 0;
    std::uint32_t more = 0, moreLength = 0;  // ADDINFO
    std::string stamp, author, family, name;
  };
  void add(Table& table);
  const Row* beside(const Row& row, std::uint32_t type) const;
  std::vector<std::uint8_t> memo(std::uint32_t block, std::uint32_t length) const;
  void readCode(const Row& row, StoredBlock& result);
  void readTexts(const Row& row, StoredBlock& result) const;

  std::string folder_;
  CodePage page_;
  Faults& faults_;
  Memo memo_;
  std::vector<Row> rows_;  // by object
  std::vector<std::pair<BlockId, std::size_t>> places_;
  std::vector<BlockId> ids_;
};

}  // namespace merker::s7p
