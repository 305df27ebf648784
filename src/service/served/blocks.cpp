#include "served/blocks.h"

#include "block/container.h"
#include "cpu/cpu.h"
#include "served/container_check.h"
#include "served/system.h"
#include "served/system_blocks.h"
#include "station/block_cpu.h"

namespace merker::served {
namespace {

using s7comm::BlockEntry;
using s7comm::BlockType;
using s7comm::Error;
using s7comm::FileSystem;

constexpr std::size_t kAttributesAt = 3, kLanguageAt = 4;  // in a container

// The character of a type is the digit of its code: OB 08h, DB 0Ah … SFB 0Fh.
std::optional<BlockType> typeOf(BlockKind kind) {
  const auto code = static_cast<std::uint8_t>(kind);
  if (code == 0x08) return BlockType::Ob;
  if (code < 0x0A || code > 0x0F) return std::nullopt;
  return static_cast<BlockType>('A' + code - 0x0A);
}

s7comm::Bytes containerOf(const station::BlockCpu& cpu, block::Block copy) {
  const auto* const values =
      copy.id.kind == BlockKind::DB ? cpu.cpu().machine().dataBlocks.find(copy.id.number) : nullptr;
  if (values != nullptr && values->data.size() == copy.actualData.size())
    copy.actualData = values->data;
  return block::writeContainer(copy);
}

void listBlocks(const block::Program& program, std::vector<BlockEntry>& all) {
  for (const auto& [id, one] : program) {
    const auto type = typeOf(id.kind);
    // What is asked for stands in the head; a checksum over all code would hold up the PLC.
    block::Block head;
    head.id = id, head.attributes = one.attributes, head.language = one.language;
    const s7comm::Bytes container = type ? block::writeContainer(head) : s7comm::Bytes();
    if (!container.empty())
      all.push_back({*type, id.number, container[kAttributesAt], container[kLanguageAt]});
  }
}

bool isSystemBlock(BlockType type) { return type == BlockType::Sfc || type == BlockType::Sfb; }

Uploaded systemBlock(const CpuModel& model, BlockId id) {
  const block::Program& all = systemBlocks(model);
  const auto found = all.find(id);
  if (found == all.end()) return {};
  return {Error::None, block::writeContainer(found->second)};
}

}  // namespace

std::optional<std::vector<BlockEntry>> blocksOf(controller::Controller& plc) {
  const auto* const cpu = controller::capability<station::BlockCpu>(plc);
  if (cpu == nullptr) return std::nullopt;
  std::vector<BlockEntry> all;
  listBlocks(cpu->program(), all);
  listBlocks(systemBlocks(cpu->model()), all);
  return all;
}

Uploaded blockOf(controller::Controller& plc, const PassiveBlocks& passive,
                 const s7comm::BlockName& name) {
  const auto* const cpu = controller::capability<station::BlockCpu>(plc);
  if (cpu == nullptr) return {Error::FunctionNotAvailable, {}};
  if (isSystemBlock(name.type)) return systemBlock(cpu->model(), idOf(name));
  s7comm::Bytes container;
  const auto found = cpu->program().find(idOf(name));
  const block::Block* const waiting = passive.find(idOf(name));
  if (name.files != FileSystem::Passive && found != cpu->program().end())
    container = containerOf(*cpu, found->second);
  else if (name.files != FileSystem::Active && waiting != nullptr)
    container = block::writeContainer(*waiting);
  return container.empty() ? Uploaded{} : Uploaded{Error::None, std::move(container)};
}

Uploaded upload(controller::Controller& plc, const PassiveBlocks& passive,
                const s7comm::BlockName& name, std::string_view password) {
  if (isProtected(plc, password, 3)) return {Error::NeedsPassword, {}};
  if (isSystemBlock(name.type)) return {};  // they stay in the operating system
  return blockOf(plc, passive, name);
}

}  // namespace merker::served
