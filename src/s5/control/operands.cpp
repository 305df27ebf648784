// The operands of the PLC as bytes, for readers outside.
#include "base/bytes.h"
#include "control/cnc.h"

namespace merker::cnc {
namespace {

template <typename Cells>
void copyCells(const Cells& cells, std::vector<std::uint8_t>& bytes) {
  bytes.resize(2 * cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) storeWord(&bytes[2 * i], cells[i].coded());
}

void copyDataBlocks(const sinumerik::BlockMemory& blocks, controller::OperandImage& image) {
  image.data.clear();
  image.dataBlocks.clear();
  const auto list = blocks.list(mc5::BlockType::Db);
  for (std::size_t number = 0; number < list.size(); ++number) {
    const sinumerik::Entry& block = list[number];
    if (!block.present) continue;
    image.dataBlocks.push_back({static_cast<std::uint16_t>(number),
                                static_cast<std::uint32_t>(image.data.size()), 2 * block.length});
    for (std::uint32_t i = 0; i < block.length; ++i)
      appendWord(image.data, blocks.data()[block.start + i]);
  }
}

}  // namespace

void Cnc::copyOperands(controller::OperandImage& image) const {
  const sinumerik::Machine& m = plc().machine();
  image.inputs.assign(m.inputs.begin(), m.inputs.end());
  image.outputs.assign(m.outputs.begin(), m.outputs.end());
  image.flags.assign(m.flags.begin(), m.flags.end());
  copyCells(m.timers, image.timers);
  copyCells(m.counters, image.counters);
  copyDataBlocks(m.blocks, image);
}

}  // namespace merker::cnc
