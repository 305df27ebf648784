#include "served/passive_blocks.h"

#include <algorithm>

#include "cpu/cpu.h"
#include "served/blocks.h"
#include "served/container_check.h"
#include "served/system.h"
#include "station/block_cpu.h"

namespace merker::served {
namespace {

using s7comm::BlockName;
using s7comm::Error;
using s7comm::FileSystem;

// Head and end, and three parts whose lengths are words (docs/formats/block.md).
constexpr std::size_t kLongestContainer = 72 + 3 * 0xFFFF;

Error whyNotLoaded(controller::Controller& plc, std::string_view password) {
  if (controller::capability<station::BlockCpu>(plc) == nullptr) return Error::FunctionNotAvailable;
  return mayLoad(plc, password) ? Error::None : Error::NeedsPassword;
}

bool tooLarge(const CpuModel& model, const block::Block& block) {
  return block.code.size() > model.blockSize || block.actualData.size() > model.dataBlockSize;
}

// A block that is the same in load memory counts as no change; its values are loaded all the same
// (S7-MEM-04).
void loadValues(cpu::Cpu& cpu, const block::Block& block) {
  cpu::DataBlock* const there = cpu.machine().dataBlocks.find(block.id.number);
  if (block.id.kind == BlockKind::DB && there != nullptr &&
      there->data.size() == block.actualData.size())
    std::ranges::copy(block.actualData, there->data.begin());
}

ProgramChange planned(controller::Controller& plc, const std::string& password) {
  ProgramChange change{.error = whyNotLoaded(plc, password), .password = password};
  if (change.error != Error::None) return change;
  const auto* const cpu = controller::capability<station::BlockCpu>(plc);
  change.before = cpu->loaded();
  change.engine = cpu->engine();
  change.model = &cpu->model();
  return change;
}

}  // namespace

const block::Block* PassiveBlocks::find(BlockId id) const {
  const auto found = blocks_.find(id);
  return found == blocks_.end() ? nullptr : found->second.block.get();
}

std::size_t PassiveBlocks::octets(BlockId except) const {
  std::size_t sum = 0;
  for (const auto& [id, kept] : blocks_)
    if (id != except) sum += kept.octets;
  return sum;
}

Error PassiveBlocks::admit(controller::Controller& plc, const BlockName& name, std::size_t octets,
                           std::string_view password) const {
  if (const Error why = whyNotLoaded(plc, password); why != Error::None) return why;
  const CpuModel& model = controller::capability<station::BlockCpu>(plc)->model();
  const BlockId id = idOf(name);
  if (!hasNumber(model, id)) return Error::WrongBlockNumber;
  if (octets > kLongestContainer) return Error::BlockTooLarge;
  return this->octets(id) + octets > model.loadMemory ? Error::NoMemory : Error::None;
}

Error PassiveBlocks::keep(controller::Controller& plc, std::shared_ptr<const block::Block> block,
                          std::size_t octets, std::string_view password) {
  if (const Error why = whyNotLoaded(plc, password); why != Error::None) return why;
  const CpuModel& model = controller::capability<station::BlockCpu>(plc)->model();
  if (tooLarge(model, *block)) return Error::BlockTooLarge;
  if (this->octets(block->id) + octets > model.loadMemory) return Error::NoMemory;
  blocks_[block->id] = {block, octets};
  return Error::None;
}

ProgramChange PassiveBlocks::link(controller::Controller& plc, const Names& names,
                                  const std::string& password) const {
  ProgramChange change = planned(plc, password);
  for (const BlockName& name : names) {
    const auto found = blocks_.find(idOf(name));
    if (change.error == Error::None && found == blocks_.end()) change.error = Error::NoSuchBlock;
    if (change.error != Error::None) return change;
    change.linked.push_back(found->second.block);
    change.noLongerPassive.push_back(found->first);
  }
  return change;
}

ProgramChange PassiveBlocks::remove(controller::Controller& plc, const Names& names,
                                    const std::string& password) const {
  ProgramChange change = planned(plc, password);
  if (change.error != Error::None) return change;
  for (const BlockName& name : names) {
    const BlockId id = idOf(name);
    const bool active = name.files != FileSystem::Passive && change.before->contains(id);
    const bool passive = name.files != FileSystem::Active && blocks_.contains(id);
    if (active) change.deleted.push_back(id);
    if (passive) change.noLongerPassive.push_back(id);
    if (active || passive) continue;
    // One that is listed all the same belongs to the configuration or the operating system.
    const bool listed = blockOf(plc, *this, name).error == Error::None;
    change.error = listed ? Error::AccessRefused : Error::NoSuchBlock;
  }
  return change;
}

bool PassiveBlocks::carryOut(controller::Controller& plc, ProgramChange& change) {
  const ProgramChange now = planned(plc, change.password);
  change.error = now.error;
  if (now.error != Error::None) return true;
  if (now.before != change.before || now.engine != change.engine) return false;
  if (change.changesProgram()) {
    auto* const cpu = controller::capability<station::BlockCpu>(plc);
    cpu->supply(change.translations);
    if (!cpu->download(change.after, change.password).empty()) change.error = Error::NeedsPassword;
    if (change.error != Error::None) return true;
    for (const auto& block : change.linked) loadValues(cpu->cpu(), *block);
  }
  for (const BlockId id : change.noLongerPassive) blocks_.erase(id);
  return true;
}

}  // namespace merker::served
