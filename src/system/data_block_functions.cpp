// SFC 22 CREAT_DB, 23 DEL_DB, 24 TEST_DB (S7-SFC-10).
#include "system/arguments.h"

namespace merker::system {
namespace {

constexpr std::uint32_t kNumberError = 0x80A1, kLengthError = 0x80A2, kNoFreeNumber = 0x80B1;
constexpr std::uint32_t kMissing = 0x80B1, kNotDeletable = 0x80B3, kWrongNumber = 0x80A1;

// The lowest free number between the limits.
void create(Arguments& a) {
  const std::uint32_t low = a.value(0), high = a.value(1), bytes = a.value(2);
  cpu::Machine& m = a.machine();
  const auto highest = static_cast<std::uint32_t>(m.model->highestDb);
  if (low == 0 || low > high || high > highest) return a.status(kNumberError);
  if (bytes == 0 || bytes % 2 != 0 || bytes > m.model->dataBlockSize) return a.status(kLengthError);
  for (std::uint32_t number = low; number <= high; ++number) {
    if (m.dataBlocks.find(number) != nullptr) continue;
    m.dataBlocks.create(number, bytes);
    m.reopenBlocks();
    a.set(3, number);
    return a.status(0);
  }
  a.status(kNoFreeNumber);
}

void remove(Arguments& a) {
  const std::uint32_t number = a.value(0);
  cpu::Machine& m = a.machine();
  if (number == 0 || number > static_cast<std::uint32_t>(m.model->highestDb))
    return a.status(kWrongNumber);
  const cpu::DataBlock* block = m.dataBlocks.find(number);
  if (block == nullptr) return a.status(kMissing);
  if (block->readOnly) return a.status(kNotDeletable);
  m.dataBlocks.remove(number);
  m.reopenBlocks();
  a.status(0);
}

void test(Arguments& a) {
  const std::uint32_t number = a.value(0);
  cpu::Machine& m = a.machine();
  if (number == 0 || number > static_cast<std::uint32_t>(m.model->highestDb))
    return a.status(kWrongNumber);
  const cpu::DataBlock* block = m.dataBlocks.find(number);
  a.set(1, block == nullptr ? 0 : static_cast<std::uint32_t>(block->data.size()));
  a.set(2, block != nullptr && block->readOnly);
  a.status(block == nullptr ? kMissing : 0);
}

}  // namespace

Functions dataBlockFunctions() {
  using enum TypeCode;
  return {
      {BlockKind::SFC,
       22,
       "CREAT_DB",
       {{"LOW_LIMIT", kIn, Word},
        {"UP_LIMIT", kIn, Word},
        {"COUNT", kIn, Word},
        {"DB_NUMBER", kOut, Word},
        {"RET_VAL", kReturn, Int}},
       create},
      {BlockKind::SFC, 23, "DEL_DB", {{"DB_NUMBER", kIn, Word}, {"RET_VAL", kReturn, Int}}, remove},
      {BlockKind::SFC,
       24,
       "TEST_DB",
       {{"DB_NUMBER", kIn, Word},
        {"DB_LENGTH", kOut, Word},
        {"WRITE_PROT", kOut, Bool},
        {"RET_VAL", kReturn, Int}},
       test}};
}

}  // namespace merker::system
