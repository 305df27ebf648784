#include "s7comm/block_watch.h"

#include <bit>

#include "base/bytes.h"

namespace merker::s7comm {
namespace {

constexpr std::size_t kBlockAt = 20, kShortest = 28;  // block, number, begin, length behind them
constexpr std::size_t kEnvironmentAt = 28, kEnvironment = 36;

// What the conditions of a call are about.
constexpr std::uint16_t kOpenBlocks = 2, kCaller = 1, kDbOpen = 0x0A00, kDiOpen = 0x000A;

void readEnvironment(View parameters, BlockWatch& watch) {
  const std::uint16_t about = loadWord(&parameters[kEnvironmentAt]);
  const std::uint16_t condition = loadWord(&parameters[kEnvironmentAt + 2]);
  const std::uint16_t first = loadWord(&parameters[kEnvironmentAt + 4]);
  const std::uint16_t second = loadWord(&parameters[kEnvironmentAt + 6]);
  if (about != kOpenBlocks) {
    if ((condition & kCaller) != 0) watch.caller = {first, second};
    return;
  }
  if ((condition & kDbOpen) == kDbOpen) watch.db = first;
  if ((condition & kDiOpen) == kDiOpen) watch.di = second;
}

// The mask of block status 1 has one bit for both accumulators and one for both data blocks, and
// always the status word.
std::uint8_t oldMask(std::uint8_t mask) {
  constexpr std::uint8_t kNew[] = {kAccu1 | kAccu2, kAr1, kAr2, kDb};
  std::uint8_t registers = kStatusWord;
  for (unsigned bit = 0; bit < std::size(kNew); ++bit)
    if ((mask >> bit & 1) != 0) registers |= kNew[bit];
  return registers;
}

// Two octets for each word of code: 80h and the mask where an instruction begins, 80h 80h where
// nothing is asked of it, 00h 00h inside of it.
Error readOldLines(View data, BlockWatch& watch) {
  constexpr std::uint8_t kInstruction = 0x80;
  if (data.size() < 2) return Error::WrongJobLength;
  watch.registers = oldMask(data[1]);
  std::uint16_t address = watch.begin;
  for (View rest = data.subspan(2); rest.size() >= 2; rest = rest.subspan(2), address += 2)
    if (rest[0] == kInstruction && rest[1] != kInstruction)
      watch.lines.push_back({address, oldMask(rest[1])});
  return Error::None;
}

// 80h, how many, 0, the mask of the beginning; of each line its address, 0, its mask.
Error readLines(View data, BlockWatch& watch) {
  constexpr std::size_t kLine = 4;
  if (data.size() < kLine || data.size() < kLine + kLine * data[1]) return Error::WrongJobLength;
  watch.registers = data[3];
  for (std::size_t i = 1; i <= data[1]; ++i)
    watch.lines.push_back({loadWord(&data[i * kLine]), data[i * kLine + 3]});
  return Error::None;
}

}  // namespace

Error readBreakpoint(View parameters, BlockWatch& watch) {
  if (parameters.size() < kBlockAt + 6) return Error::WrongJobLength;
  watch.type = loadWord(&parameters[kBlockAt]);
  watch.number = loadWord(&parameters[kBlockAt + 2]);
  watch.begin = loadWord(&parameters[kBlockAt + 4]);
  return Error::None;
}

Error readBlockWatch(TestFunction function, View parameters, View data, BlockWatch& watch) {
  if (parameters.size() < kShortest) return Error::WrongJobLength;
  readBreakpoint(parameters, watch);
  if (parameters.size() >= kEnvironment) readEnvironment(parameters, watch);
  return function == TestFunction::BlockStatus ? readOldLines(data, watch) : readLines(data, watch);
}

// STW 2 octets, the other registers 4; both data blocks together: their types, their numbers.
std::size_t registerOctets(std::uint8_t registers) {
  constexpr unsigned kLong = kAccu1 | kAccu2 | kAr1 | kAr2;
  return ((registers & kStatusWord) != 0 ? 2u : 0u) +
         4u * static_cast<unsigned>(std::popcount(registers & kLong)) +
         ((registers & (kDb | kDi)) != 0 ? 6u : 0u);
}

void appendOpenBlocks(Bytes& data, std::uint16_t db, std::uint16_t di) {
  constexpr std::uint8_t kDataBlock = 0x0A;
  for (const std::uint16_t number : {db, di}) data.push_back(number == 0 ? 0 : kDataBlock);
  for (const std::uint16_t number : {db, di}) appendWord(data, number);
}

void appendRegisters(Bytes& data, const TestRegisters& values, std::uint8_t registers) {
  struct Long {
    std::uint8_t bit;
    std::uint32_t value;
  };
  const Long longs[] = {
      {kAccu1, values.accu1}, {kAccu2, values.accu2}, {kAr1, values.ar1}, {kAr2, values.ar2}};
  if ((registers & kStatusWord) != 0) appendWord(data, values.status);
  for (const Long& one : longs)
    if ((registers & one.bit) != 0) appendDWord(data, one.value);
  if ((registers & (kDb | kDi)) != 0) appendOpenBlocks(data, values.db, values.di);
}

}  // namespace merker::s7comm
