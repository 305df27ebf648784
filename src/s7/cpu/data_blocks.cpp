#include "cpu/data_blocks.h"

namespace merker::cpu {

void DataBlocks::load(const block::Block& source) {
  if (source.attributes.unlinked) return;  // S7-MEM-03: stays in load memory
  put(source.id.number,
      {.loaded = true,
       .readOnly = source.attributes.readOnly,
       .retentive = !source.attributes.nonRetain,
       .data = source.actualData.empty() ? source.initialData : source.actualData});
}

void DataBlocks::put(std::uint32_t number, DataBlock block) {
  if (blocks_.size() <= number) blocks_.resize(number + 1);
  DataBlock& placed = blocks_[number] = std::move(block);
  const auto length = static_cast<std::uint32_t>(placed.data.size());
  placed.open = {.data = placed.data.data(),
                 .length = length,
                 .writable = placed.readOnly ? 0 : length,
                 .number = static_cast<std::uint16_t>(number)};
}

void DataBlocks::load(const block::Program& program) {
  blocks_.clear();
  for (const auto& [id, source] : program)
    if (id.kind == BlockKind::DB) load(source);
}

void DataBlocks::loadNonRetentive(const block::Program& program) {
  for (const auto& [id, source] : program)
    if (id.kind == BlockKind::DB && source.attributes.nonRetain) load(source);
}

DataBlock* DataBlocks::find(std::uint32_t number) {
  return number < blocks_.size() && blocks_[number].loaded ? &blocks_[number] : nullptr;
}

const DataBlock* DataBlocks::find(std::uint32_t number) const {
  return number < blocks_.size() && blocks_[number].loaded ? &blocks_[number] : nullptr;
}

OpenBlock DataBlocks::open(std::uint32_t number) const {
  return number < blocks_.size() ? blocks_[number].open : OpenBlock{};
}

void DataBlocks::create(std::uint32_t number, std::uint32_t length) {
  put(number, {.loaded = true, .madeByProgram = true, .data = std::vector<std::uint8_t>(length)});
}

void DataBlocks::remove(std::uint32_t number) {
  if (number < blocks_.size()) blocks_[number] = {};
}

}  // namespace merker::cpu
