#include "softplc/start_checks.h"

#include <array>

#include "base/bcd.h"
#include "softplc/periphery_check.h"

namespace merker::sinumerik {
namespace {

using mc5::BlockId;
using mc5::BlockType;

constexpr std::array kCodeTypes{BlockType::Ob, BlockType::Pb, BlockType::Sb, BlockType::Fb};
constexpr std::uint8_t kAlarmOb = 2;
constexpr std::uint32_t kDecodingUnit = 6;  // words

struct Situation {
  Machine& machine;
  const Options& options;
  const MachineData& data;
  const Surroundings& around;
  const Checksums& sums;
  bool alarmLevel;
};
using Found = std::optional<StartFault>;

std::uint16_t bcd(std::uint32_t number) { return static_cast<std::uint16_t>(toBcd(number, 4)); }
StartFault fault(Alarm alarm, std::uint16_t word3 = 0, ControlBit also = ControlBit::NONE) {
  return {{alarm, {0, 0, word3}}, also};
}

Found machineData(Situation& s) {
  if (const auto alarm = s.data.illegal()) return fault(*alarm);
  return std::nullopt;
}

Found memory(Situation& s) {
  if (!s.around.programMemoryFitted || !s.around.dataMemoryFitted)
    return fault(Alarm::MemoryGap, 0, ControlBit::KEINPS);
  if (s.around.memoryGap) return fault(Alarm::MemoryGap);
  return std::nullopt;
}

Found modules(Situation& s) {
  if (const auto trap = checkModules(s.around.modules)) return StartFault{*trap, ControlBit::NONE};
  mount(s.around.modules, s.machine.periphery);
  const unsigned byte = s.data.word(0);
  if (s.alarmLevel && !s.machine.periphery.inputPresent[byte])
    return fault(Alarm::AlarmByteMissing, bcd(byte));
  return std::nullopt;
}

Found basicProgram(Situation& s) {
  switch (s.around.basicProgram) {
    case EpromFault::Synchronisation:
      return fault(Alarm::BasicSynchronisation);
    case EpromFault::Block:
      return fault(Alarm::BasicBlock);
    case EpromFault::Checksum:
      return fault(Alarm::BasicChecksum);
    case EpromFault::None:
      return std::nullopt;
  }
  return std::nullopt;
}

StartFault damaged(const BlockMemory::Damage& damage) {
  const bool program = damage.segment == kProgramSegment;
  const auto place = static_cast<std::uint16_t>(damage.word);
  if (damage.synchronisation)
    return fault(program ? Alarm::ProgramSynchronisation : Alarm::DataSynchronisation, place);
  return fault(program ? Alarm::ProgramBlock : Alarm::DataBlock, place,
               damage.length ? ControlBit::SYNFEH : ControlBit::NONE);
}

Found blocks(Situation& s) {
  if (const auto damage = s.machine.blocks.buildLists()) return damaged(*damage);
  if (const auto id = s.sums.changed(s.machine.blocks))
    return fault(Alarm::ProgramChecksum, bcd(id->number));
  if (!createSystemBlocks(s.machine.blocks, s.options.systemBlocks))
    return fault(Alarm::MemoryGap, 0, ControlBit::KEINPS);
  return std::nullopt;
}

Found decoding(Situation& s) {
  if (!s.options.decodingDb) return std::nullopt;
  const DecodingDb& wanted = *s.options.decodingDb;
  const Entry& entry = s.machine.blocks.find({BlockType::Db, wanted.number});
  if (!entry.present) return fault(Alarm::DecodingDbMissing, bcd(wanted.number));
  if (entry.length % kDecodingUnit != 0) return fault(Alarm::DecodingDbLength, bcd(wanted.number));
  if (wanted.units == 0) return fault(Alarm::DecodingUnits, bcd(wanted.number));
  if (std::uint64_t{wanted.units} * kDecodingUnit > entry.length)
    return fault(Alarm::DecodingDbShort, bcd(wanted.number));
  return std::nullopt;
}

// OB 1 and OB 20 may be missing, OB 2 not if it could be called (S5-OB-09, OP-08).
Found alarmBlock(Situation& s) {
  if (s.alarmLevel && !s.machine.blocks.find({BlockType::Ob, kAlarmOb}).present)
    return fault(Alarm::MissingBlock, kAlarmOb);
  return std::nullopt;
}

constexpr std::array kChecks{machineData, memory,   modules,   basicProgram,
                             blocks,      decoding, alarmBlock};

std::uint16_t sumOf(const BlockMemory& blocks, const Entry& entry) {
  std::uint16_t sum = 0;
  for (std::uint32_t i = 0; i < entry.length; ++i)
    sum = static_cast<std::uint16_t>((sum << 1 | sum >> 15) + blocks.program()[entry.start + i]);
  return sum;
}

}  // namespace

void Checksums::take(const BlockMemory& blocks) {
  sums_.clear();
  for (const BlockType type : kCodeTypes) {
    const auto list = blocks.list(type);
    for (std::size_t n = 0; n < list.size(); ++n)
      if (list[n].present) sums_[{type, static_cast<std::uint16_t>(n)}] = sumOf(blocks, list[n]);
  }
}

std::optional<BlockId> Checksums::changed(const BlockMemory& blocks) const {
  for (const auto& [id, sum] : sums_) {
    const Entry& entry = blocks.find(id);
    if (entry.present && sumOf(blocks, entry) != sum) return id;
  }
  return std::nullopt;
}

std::optional<StartFault> checkStart(Machine& machine, const Options& options,
                                     const MachineData& data, const Surroundings& around,
                                     const Checksums& sums) {
  Situation situation{machine, options, data, around, sums, !data.bit(data_bit::kNoAlarmLevel)};
  for (const auto check : kChecks)
    if (auto found = check(situation)) return found;
  return std::nullopt;
}

}  // namespace merker::sinumerik
