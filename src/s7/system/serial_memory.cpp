#include "system/serial_memory.h"

#include <algorithm>

#include "base/bytes.h"

namespace merker::system {
namespace {

using serial::Bytes;

Area areaOf(char type) {
  return type == 'M' ? Area::Flag : type == 'E' ? Area::Input : Area::Output;
}

// As LC T n and LC Z n load them (PTP-SFB65-11, PTP-OPEN-17).
std::uint16_t wordOf(const cpu::Machine& m, char type, std::size_t number) {
  return type == 'T' ? m.timers[number].s5time(m.cpu->state().programTime())
                     : m.counters[number].bcd();
}

}  // namespace

std::optional<std::size_t> ProgramBlocks::size(std::uint32_t block) const {
  const cpu::OpenBlock open = m_.dataBlocks.open(block);
  if (open.number == 0) return std::nullopt;
  return access_ == cpu::Access::Write ? open.writable : open.length;
}

Bytes ProgramBlocks::read(const serial::Place& from, std::size_t count) const {
  const std::uint8_t* data = m_.dataBlocks.open(from.block).data + from.offset;
  return {data, data + count};
}

void ProgramBlocks::write(const serial::Place& to, std::span<const std::uint8_t> data) {
  std::copy(data.begin(), data.end(), m_.dataBlocks.open(to.block).data + to.offset);
}

std::optional<std::size_t> ProgramMemory::size(char type, std::uint8_t block) const {
  if (type == 'D') return ProgramBlocks(m_, cpu::Access::Read).size(block);
  if (type == 'T') return m_.timers.size();
  if (type == 'Z') return m_.counters.size();
  if (type == 'X') return std::nullopt;
  return m_.areas.length(areaOf(type));
}

bool ProgramMemory::writable(std::uint8_t block) const {
  return ProgramBlocks(m_, cpu::Access::Write).size(block).value_or(0) > 0;
}

Bytes ProgramMemory::read(char type, std::uint8_t block, std::size_t offset,
                          std::size_t count) const {
  if (type == 'D')
    return ProgramBlocks(m_, cpu::Access::Read)
        .read({block, static_cast<std::uint32_t>(offset)}, count);
  if (type != 'T' && type != 'Z') {
    const std::uint8_t* data = m_.image + m_.areas.base(areaOf(type)) + offset;
    return {data, data + count};
  }
  Bytes bytes(count);
  for (std::size_t i = 0; i + 1 < count; i += 2)
    storeWord(&bytes[i], wordOf(m_, type, offset + i / 2));
  return bytes;
}

void ProgramMemory::write(std::uint8_t block, std::size_t offset,
                          std::span<const std::uint8_t> data) {
  ProgramBlocks(m_, cpu::Access::Write).write({block, static_cast<std::uint32_t>(offset)}, data);
}

bool ProgramMemory::flag(const serial::Flag& flag) const {
  return (*m_.areas.flag(flag.byte) >> flag.bit & 1U) != 0;
}

void ProgramMemory::setFlag(const serial::Flag& flag) {
  std::uint8_t& byte = *m_.areas.flag(flag.byte);
  byte = static_cast<std::uint8_t>(byte | 1U << flag.bit);
}

}  // namespace merker::system
