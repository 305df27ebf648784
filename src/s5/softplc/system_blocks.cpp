#include "softplc/system_blocks.h"

#include <algorithm>
#include <array>

namespace merker::sinumerik {
namespace {

using mc5::BlockType;

struct SystemBlock {
  std::uint16_t number;
  std::uint32_t words;  // DB 1: DW 0..9; DB 36: 65 interface bytes; the others: own decision
  bool SystemOptions::*option;
};
constexpr std::array kBlocks{
    SystemBlock{1, 10, nullptr},  SystemBlock{36, 33, nullptr},
    SystemBlock{37, 10, nullptr}, SystemBlock{39, 20, &SystemOptions::softwareCams},
    SystemBlock{40, 40, nullptr}, SystemBlock{71, 10, &SystemOptions::adarCoupling}};

bool exists(const SystemBlock& block, const SystemOptions& options) {
  return block.option == nullptr || options.*block.option;
}

struct FaultBit {
  Alarm alarm;
  std::uint16_t bit;
};
// S5-ERR-02: DL 8 is the high byte, D 8.8 its bit 0.
constexpr std::array kFaultBits{
    FaultBit{Alarm::CyclicRunTime, 0x0100},    FaultBit{Alarm::AlarmRunTime, 0x0200},
    FaultBit{Alarm::MasterPlc, 0x0800},        FaultBit{Alarm::UnitSilent, 0x0001},
    FaultBit{Alarm::UnitTransmission, 0x0002}, FaultBit{Alarm::UnitTemperature, 0x0004},
    FaultBit{Alarm::UnitChanged, 0x0008}};

// A word of DB 1; null if somebody destroyed the block.
std::uint16_t* word(BlockMemory& blocks, std::uint32_t number) {
  const Entry& entry = blocks.find({BlockType::Db, diagnosis::kDb});
  return entry.present && number < entry.length ? &blocks.data()[entry.start + number] : nullptr;
}

std::uint16_t microseconds(Duration time) { return static_cast<std::uint16_t>(time.ns / 1000); }

}  // namespace

bool isSystemBlock(std::uint16_t db, const SystemOptions& options) {
  for (const SystemBlock& block : kBlocks)
    if (block.number == db) return exists(block, options);
  return false;
}

bool createSystemBlocks(BlockMemory& blocks, const SystemOptions& options) {
  for (const SystemBlock& block : kBlocks) {
    if (!exists(block, options) || blocks.find({BlockType::Db, block.number}).present) continue;
    if (!blocks.createData(block.number, block.words)) return false;
  }
  return true;
}

namespace diagnosis {

bool showFault(BlockMemory& blocks, Alarm alarm) {
  const auto* const row = std::ranges::find(kFaultBits, alarm, &FaultBit::alarm);
  if (row == kFaultBits.end()) return false;
  if (std::uint16_t* const faults = word(blocks, kFaults))
    *faults = static_cast<std::uint16_t>(*faults | row->bit);
  return true;
}

void showTimes(BlockMemory& blocks, Duration cycleTime, const CycleTimes& times) {
  std::uint16_t* const words = word(blocks, 0);
  const bool complete = word(blocks, kTrigger) != nullptr;
  if (!complete || (words[kTrigger] & kTriggerBit) == 0) return;
  words[kTrigger] = static_cast<std::uint16_t>(words[kTrigger] & ~kTriggerBit);
  words[kCycleTime] = static_cast<std::uint16_t>(cycleTime.ns / 1'000'000);
  words[kRunTime] = microseconds(times.cyclic + times.alarm);
  words[kCyclicTime] = microseconds(times.cyclic);
  words[kAlarmTime] = microseconds(times.alarm);
  words[kAlarmRuns] = static_cast<std::uint16_t>(times.alarmRuns);
}

}  // namespace diagnosis
}  // namespace merker::sinumerik
