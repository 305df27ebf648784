#include "softplc/system_blocks.h"

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

std::uint16_t faultBit(Alarm alarm) {
  for (const FaultBit& row : kFaultBits)
    if (row.alarm == alarm) return row.bit;
  return 0;
}

std::uint16_t* word(BlockMemory& blocks, std::uint32_t number) {
  const Entry& entry = blocks.find({BlockType::Db, kDb});
  return entry.present && number < entry.length ? &blocks.data()[entry.start + number] : nullptr;
}

}  // namespace diagnosis
}  // namespace merker::sinumerik
