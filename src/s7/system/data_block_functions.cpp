// SFC 22 CREAT_DB, 23 DEL_DB, 24 TEST_DB (S7-SFC-10).
#include "system/call.h"
#include "system/memory_use.h"

namespace merker::system {
namespace {

constexpr std::uint32_t kNumberError = 0x80A1, kLengthError = 0x80A2, kNoFreeNumber = 0x80B1,
                        kNoMemory = 0x80B2;
constexpr std::uint32_t kMissing = 0x80B1, kWrongNumber = 0x80A1;

}  // namespace

// The lowest free number between the limits.
void createDataBlock(Sfc<22>& a) {
  const std::uint32_t low = a.value("LOW_LIMIT"), high = a.value("UP_LIMIT");
  const std::uint32_t bytes = a.value("COUNT");
  cpu::Machine& m = a.machine();
  const auto highest = static_cast<std::uint32_t>(m.model->highestDb);
  if (low == 0 || low > high || high > highest) return a.status(kNumberError);
  if (bytes == 0 || bytes % 2 != 0 || bytes > m.model->dataBlockSize) return a.status(kLengthError);
  if (memoryUse(m).work + bytes > m.model->workMemory) return a.status(kNoMemory);
  for (std::uint32_t number = low; number <= high; ++number) {
    if (m.dataBlocks.find(number) != nullptr) continue;
    m.dataBlocks.create(number, bytes);
    m.reopenBlocks();
    a.set("DB_NUMBER", number);
    return a.status(0);
  }
  a.status(kNoFreeNumber);
}

void deleteDataBlock(Sfc<23>& a) {
  const std::uint32_t number = a.value("DB_NUMBER");
  cpu::Machine& m = a.machine();
  if (number == 0 || number > static_cast<std::uint32_t>(m.model->highestDb))
    return a.status(kWrongNumber);
  const cpu::DataBlock* block = m.dataBlocks.find(number);
  if (block == nullptr) return a.status(kMissing);
  m.dataBlocks.remove(number);
  m.reopenBlocks();
  a.status(0);
}

void testDataBlock(Sfc<24>& a) {
  const std::uint32_t number = a.value("DB_NUMBER");
  cpu::Machine& m = a.machine();
  if (number == 0 || number > static_cast<std::uint32_t>(m.model->highestDb))
    return a.status(kWrongNumber);
  const cpu::DataBlock* block = m.dataBlocks.find(number);
  a.set("DB_LENGTH", block == nullptr ? 0 : static_cast<std::uint32_t>(block->data.size()));
  a.set("WRITE_PROT", block != nullptr && block->readOnly);
  a.status(block == nullptr ? kMissing : 0);
}

}  // namespace merker::system
