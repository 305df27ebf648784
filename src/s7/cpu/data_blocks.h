// The data blocks in work memory, by number.
#pragma once

#include <cstdint>
#include <vector>

#include "block/block.h"
#include "cpu/registers.h"

namespace merker::cpu {

struct DataBlock {
  bool loaded = false;
  bool readOnly = false;
  bool retentive = true;
  bool madeByProgram = false;  // CREAT_DB: not in load memory
  std::vector<std::uint8_t> data{};
  OpenBlock open{};  // what AUF puts into a register; number 0: not loaded
};

class DataBlocks {
 public:
  // All blocks as load memory has them (S7-MEM-04): the actual values that were downloaded.
  void load(const block::Program& program);
  void load(const block::Block& source);  // one of them
  // Only those that a restart sets back (NON_RETAIN).
  void loadNonRetentive(const block::Program& program);

  DataBlock* find(std::uint32_t number);
  const DataBlock* find(std::uint32_t number) const;
  const std::vector<DataBlock>& all() const { return blocks_; }  // by number; not all are loaded
  // Number 0 or a missing block: nothing open.
  OpenBlock open(std::uint32_t number) const;
  void create(std::uint32_t number, std::uint32_t length);
  void remove(std::uint32_t number);

 private:
  void put(std::uint32_t number, DataBlock block);
  std::vector<DataBlock> blocks_;
};

}  // namespace merker::cpu
