#include "served/blocks.h"

#include <algorithm>
#include <utility>

#include "block/container.h"
#include "cpu/cpu.h"
#include "plant/field.h"
#include "served/container_check.h"
#include "served/system.h"
#include "served/system_blocks.h"
#include "served/system_data.h"
#include "station/block_cpu.h"

namespace merker::served {
namespace {

using s7comm::BlockEntry;
using s7comm::BlockType;
using s7comm::Error;
using s7comm::FileSystem;

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
    if (type) all.push_back({*type, id.number, static_cast<std::uint8_t>(one.language)});
  }
}

bool isSystemBlock(BlockType type) { return type == BlockType::Sfc || type == BlockType::Sfb; }

const block::Block* findBlock(const block::Program& program, BlockId id) {
  const auto found = program.find(id);
  return found == program.end() ? nullptr : &found->second;
}

Uploaded systemBlock(const CpuModel& model, BlockId id) {
  const block::Block* const found = findBlock(systemBlocks(model), id);
  return found == nullptr ? Uploaded{} : Uploaded{Error::None, block::writeContainer(*found)};
}

// Without those in whose place a client has loaded others.
block::Program systemDataOf(const controller::Controller& plc, const station::BlockCpu& cpu) {
  const auto* const field = controller::capability<plant::Field>(plc);
  const io::Rack* const rack = field == nullptr ? nullptr : field->rack();
  block::Program made = systemData(cpu.model(), cpu.cpu().parameters(),
                                   rack == nullptr ? nullptr : &rack->configuration());
  std::erase_if(made, [&](const auto& one) { return cpu.program().contains(one.first); });
  return made;
}

// Empty: there is no such block.
s7comm::Bytes activeContainer(const controller::Controller& plc, const station::BlockCpu& cpu,
                              BlockId id) {
  if (const block::Block* const found = findBlock(cpu.program(), id))
    return containerOf(cpu, *found);
  if (id.kind != BlockKind::SDB) return {};
  const block::Program made = systemDataOf(plc, cpu);
  const block::Block* const found = findBlock(made, id);
  return found == nullptr ? s7comm::Bytes{} : block::writeContainer(*found);
}

}  // namespace

bool hasNumber(const CpuModel& model, BlockId id) {
  switch (id.kind) {
    case BlockKind::SDB:
      return true;
    case BlockKind::SFC:
    case BlockKind::SFB:
      return false;
    default:
      return model.allows(id);
  }
}

std::optional<std::vector<BlockEntry>> blocksOf(controller::Controller& plc) {
  const auto* const cpu = controller::capability<station::BlockCpu>(plc);
  if (cpu == nullptr) return std::nullopt;
  std::vector<BlockEntry> all;
  listBlocks(cpu->program(), all);
  listBlocks(systemDataOf(plc, *cpu), all);
  listBlocks(systemBlocks(cpu->model()), all);
  std::ranges::sort(all, {}, [](const BlockEntry& one) { return std::pair(one.type, one.number); });
  return all;
}

Uploaded blockOf(controller::Controller& plc, const PassiveBlocks& passive,
                 const s7comm::BlockName& name) {
  const auto* const cpu = controller::capability<station::BlockCpu>(plc);
  if (cpu == nullptr) return {Error::FunctionNotAvailable, {}};
  if (isSystemBlock(name.type)) return systemBlock(cpu->model(), idOf(name));
  const BlockId id = idOf(name);
  s7comm::Bytes container;
  if (name.files != FileSystem::Passive) container = activeContainer(plc, *cpu, id);
  const block::Block* const waiting = passive.find(id);
  if (container.empty() && name.files != FileSystem::Active && waiting != nullptr)
    container = block::writeContainer(*waiting);
  return container.empty() ? Uploaded{} : Uploaded{Error::None, std::move(container)};
}

Uploaded upload(controller::Controller& plc, const PassiveBlocks& passive,
                const s7comm::BlockName& name, std::string_view password) {
  if (isProtected(plc, password, 3)) return {Error::NeedsPassword, {}};
  if (isSystemBlock(name.type)) return {};  // they stay in the operating system
  const auto* const cpu = controller::capability<station::BlockCpu>(plc);
  if (cpu != nullptr && !hasNumber(cpu->model(), idOf(name))) return {Error::NotForUpload, {}};
  return blockOf(plc, passive, name);
}

}  // namespace merker::served
