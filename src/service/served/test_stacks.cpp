#include "served/test_stacks.h"

#include <algorithm>

#include "base/bytes.h"

namespace merker::served {
namespace {

using monitor::Stacks;
using s7comm::Bytes;

// The start information of an OB: 12 octets, then when it was started.
constexpr std::size_t kStartInformation = 20, kStartedAt = 12;

void appendZeros(Bytes& data, std::size_t count) { data.resize(data.size() + count); }

Bytes startInformation(const Stacks& stacks, std::size_t block) {
  Bytes information = stacks.locals[block].bytes;
  information.resize(kStartInformation);
  return information;
}

// The OB of the priority class that this block runs in.
std::size_t obOf(const Stacks& stacks, std::size_t block) {
  while (block + 1 < stacks.blocks.size() && !stacks.blocks[block].organizationBlock) ++block;
  return block;
}

// The class of a block: classes are in the order of their OBs.
const monitor::InterruptStackEntry& classOf(const Stacks& stacks, std::size_t block) {
  const auto begin = stacks.blocks.begin();
  const auto obs = std::count_if(begin, begin + static_cast<std::ptrdiff_t>(block),
                                 [](const auto& one) { return one.organizationBlock; });
  return stacks.interrupts[std::min(static_cast<std::size_t>(obs), stacks.interrupts.size() - 1)];
}

void appendClass(Bytes& data, const Stacks& stacks, std::size_t block) {
  const Bytes information = startInformation(stacks, obOf(stacks, block));
  data.insert(data.end(), {classOf(stacks, block).priority, 0, 0, 0});
  data.insert(data.end(), information.begin() + kStartedAt, information.end());
}

}  // namespace

void appendPlace(Bytes& data, const monitor::SourcePlace& place) {
  appendWord(data, static_cast<std::uint32_t>(place.block.kind));
  appendWord(data, place.block.number);
  appendWord(data, place.offset);
}

Bytes interruptStackData(const Stacks& stacks) {
  Bytes data;
  if (stacks.blocks.empty() || stacks.interrupts.empty()) return data;
  const monitor::InterruptStackEntry& top = stacks.interrupts.front();
  const monitor::Registers& r = top.registers;
  appendPlace(data, top.place);
  s7comm::appendOpenBlocks(data, r.db, r.di.value_or(0));
  appendZeros(data, 4);
  for (const std::uint32_t accu : r.accu) appendDWord(data, accu);
  appendDWord(data, r.ar1.value_or(0));
  appendDWord(data, r.ar2.value_or(0));
  appendZeros(data, 2);
  appendWord(data, r.word);
  appendPlace(data, stacks.blocks.front().place);
  appendZeros(data, 6);
  const Bytes information = startInformation(stacks, obOf(stacks, 0));
  data.insert(data.end(), information.begin(), information.end());
  return data;
}

Bytes blockStackData(const Stacks& stacks) {
  Bytes data;
  for (std::size_t i = 0; i < stacks.blocks.size(); ++i) {
    const monitor::BlockStackEntry& one = stacks.blocks[i];
    appendPlace(data, one.place);
    s7comm::appendOpenBlocks(data, one.db, one.di);
    appendZeros(data, 4);
    if (one.organizationBlock) appendClass(data, stacks, i);
  }
  return data;
}

Bytes localStackData(const Stacks& stacks, std::uint8_t priority, std::uint8_t depth) {
  Bytes data;
  for (std::size_t i = stacks.blocks.size(); i-- > 0;) {
    if (classOf(stacks, i).priority != priority || obOf(stacks, i) != i + depth) continue;
    const Bytes& local = stacks.locals[i].bytes;
    appendPlace(data, stacks.blocks[i].place);
    appendWord(data, static_cast<std::uint32_t>(local.size()));
    data.insert(data.end(), local.begin(), local.end());
    appendClass(data, stacks, i);
    return data;
  }
  return data;
}

}  // namespace merker::served
