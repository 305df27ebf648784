// 16#0131: what a CPU offers to programming devices and partners. Bits by their numbers, from bit 0
// of the first byte on, as Wireshark's dissector names them.
#include <algorithm>
#include <span>

#include "system/function.h"
#include "system/szl.h"

namespace merker::system {
namespace {

using Bits = std::span<const std::uint8_t>;

void addBits(SzlList& list, Bits bits, std::size_t bytes) {
  const std::size_t begin = list.data.size();
  list.data.resize(begin + bytes);
  for (const std::uint8_t bit : bits)
    list.data[begin + bit / 8] |= static_cast<std::uint8_t>(1u << bit % 8);
}

// INDEX 2: functions of test and installation by the number of their subfunction
// (docs/compatibility.md), 12 bytes, trigger events: at once, system trigger, begin and end of the
// cycle, transition to STOP, area of code addresses.
void testOffers(const SzlSource&, SzlList& list) {
  constexpr std::size_t kFunctions = 6, kSegments = 12, kEvents = 3;
  constexpr std::uint8_t kTestFunctions[] = {0x01, 0x02, 0x03, 0x04, 0x05, 0x08, 0x09, 0x0A, 0x0B,
                                             0x0C, 0x0D, 0x0E, 0x0F, 0x10, 0x11, 0x12, 0x13, 0x16};
  constexpr std::uint8_t kTriggers[] = {0, 1, 2, 3, 4, 6};
  addBits(list, kTestFunctions, kFunctions);
  list.data.resize(list.data.size() + kSegments);
  addBits(list, kTriggers, kEvents);
}

// INDEX 3: reads, writes, cyclic reads that begin at once, and their end; P, I, Q, M, data blocks,
// counters, timers; bytes that are read consistently; jobs, shortest and longest interval (100 ms).
void panelOffers(const SzlSource& source, SzlList& list) {
  constexpr std::uint8_t kPanelFunctions[] = {0, 1, 2, 5, 12, 13, 14, 15, 16, 23, 24};
  constexpr std::uint32_t kJobs = 32, kShortest = 1, kLongest = 255 * 100;
  addBits(list, kPanelFunctions, 4);
  for (const std::uint32_t word :
       {std::uint32_t{communicationOf(source).parameters.pdu}, kJobs, kShortest, kLongest})
    list.word(word);
}

// INDEX 4: directories, download, link, delete, upload; load into RAM, compress. Blocks of a job:
// as many names as a PDU of 240 bytes holds; uploads at the same time: one a connection.
void blockOffers(const SzlSource& source, SzlList& list) {
  constexpr std::uint8_t kBlockFunctions[] = {1, 2, 3, 4, 5, 7, 8, 16, 21};
  constexpr std::uint32_t kNames = 25;
  addBits(list, kBlockFunctions, 8);
  for (int i = 0; i < 3; ++i) list.byte(kNames);
  list.byte(std::min(communicationOf(source).connections(), 0xFFu));
}

// INDEX 5: a diagnostic buffer, entries of the system and of the program and modes are sent,
// diagnostic interrupts are evaluated; to how many, entries of the buffer.
void diagnosisOffers(const SzlSource& source, SzlList& list) {
  constexpr std::uint8_t kDiagnosis[] = {1, 2, 3, 4, 5};
  addBits(list, kDiagnosis, 8);
  list.word(communicationOf(source).connections());
  list.word(cpu::Diagnostics::kCapacity);
}

struct BlockBit {
  std::uint8_t bit;
  BlockKind kind;
  std::uint16_t number;
};

// INDEX 6: blocks for communication that the model has.
constexpr BlockBit kBlockBits[] = {
    {0, BlockKind::SFB, 8},   {1, BlockKind::SFB, 9},   {4, BlockKind::SFB, 12},
    {5, BlockKind::SFB, 13},  {6, BlockKind::SFB, 14},  {7, BlockKind::SFB, 15},
    {8, BlockKind::SFB, 16},  {11, BlockKind::SFB, 19}, {12, BlockKind::SFB, 20},
    {13, BlockKind::SFB, 21}, {14, BlockKind::SFB, 22}, {15, BlockKind::SFB, 23},
    {21, BlockKind::SFB, 33}, {22, BlockKind::SFB, 34}, {23, BlockKind::SFB, 35},
    {24, BlockKind::SFB, 36}, {25, BlockKind::SFB, 37}, {48, BlockKind::SFC, 65},
    {49, BlockKind::SFC, 66}, {50, BlockKind::SFC, 67}, {51, BlockKind::SFC, 68},
    {52, BlockKind::SFC, 69}, {53, BlockKind::SFC, 72}, {54, BlockKind::SFC, 73},
    {55, BlockKind::SFC, 74}, {57, BlockKind::SFC, 17}, {58, BlockKind::SFC, 18},
    {59, BlockKind::SFC, 19}, {60, BlockKind::SFC, 9},  {61, BlockKind::SFC, 10},
    {62, BlockKind::SFC, 62}};

void partnerOffers(const SzlSource& source, SzlList& list) {
  const std::vector<Function> all = allFunctions(*source.cpu.machine().model);
  std::vector<std::uint8_t> bits;
  for (const BlockBit& block : kBlockBits)
    if (std::ranges::any_of(all, [&](const Function& one) {
          return one.kind == block.kind && one.number == block.number;
        }))
      bits.push_back(block.bit);
  addBits(list, bits, 8);
}

// INDEX 7: global data, which there are none of.
void noOffers(const SzlSource&, SzlList&) {}

constexpr struct {
  std::uint32_t index;
  void (*fill)(const SzlSource&, SzlList&);
} kOfferRows[] = {{1, szlConnections},  {2, testOffers},    {3, panelOffers}, {4, blockOffers},
                  {5, diagnosisOffers}, {6, partnerOffers}, {7, noOffers}};

}  // namespace

void szlOffers(const SzlSource& source, std::uint32_t index, SzlList& list) {
  const auto* const row =
      std::ranges::find(kOfferRows, index, [](const auto& one) { return one.index; });
  if (row == std::end(kOfferRows)) return;
  list.word(index);
  row->fill(source, list);
  list.data.resize(list.recordLength);
}

}  // namespace merker::system
