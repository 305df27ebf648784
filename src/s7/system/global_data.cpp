#include "system/global_data.h"

#include <algorithm>
#include <utility>

#include "base/bytes.h"
#include "system/arguments.h"

namespace merker::system {
namespace {

using cpu::Access;
using cpu::ErrorCode;

// In front of the data on the line: what it is and the high bits of its number, circle, packet,
// whether the sender was restarted and the low bits of its number.
constexpr std::uint8_t kGlobal = 0x40, kGlobalKind = 0xF0, kRestarted = 0x80;
constexpr std::size_t kGlobalHead = 4;
constexpr std::uint16_t kNumbers = 1 << 11;

bool isGlobal(const std::vector<std::uint8_t>& data) {
  return data.size() >= kGlobalHead && (data[0] & kGlobalKind) == kGlobal;
}
std::uint16_t numberOf(const std::vector<std::uint8_t>& data) {
  return static_cast<std::uint16_t>((data[0] & 0x0F) << 7 | (data[3] & 0x7F));
}

Region globalRegion(cpu::Cpu& cpu, const network::GlobalArea& where, Access access) {
  const std::uint32_t pointer = static_cast<std::uint32_t>(where.area) << 24 | where.byte * 8;
  return regionOf(
      cpu.machine(),
      {.type = TypeCode::Byte, .count = where.length, .db = where.db, .pointer = pointer},
      where.length, access);
}

// The program resets the bits, so they are added.
void addBits(cpu::Cpu& cpu, const std::optional<network::GlobalArea>& status, std::uint32_t bits) {
  if (!status || bits == 0) return;
  const Region region = globalRegion(cpu, *status, Access::Write);
  if (region) storeDWord(region.data, loadDWord(region.data) | bits);
}

}  // namespace

GlobalDataExchange::GlobalDataExchange(const network::GlobalData& data)
    : groupStatus_(data.groupStatus) {
  for (const network::GlobalPacket& row : data.packets) {
    Packet packet;
    packet.row = row;
    packets_.push_back(std::move(packet));
  }
}

// Of several packets since the last checkpoint the newest one counts.
void GlobalDataExchange::sort(BasicCommunication& interface) {
  for (network::Telegram& telegram : interface.others()) {
    if (!isGlobal(telegram.data)) continue;
    for (Packet& packet : packets_) {
      if (packet.row.sends || packet.row.circle != telegram.data[1] ||
          packet.row.packet != telegram.data[2])
        continue;
      packet.arrive(telegram.data);
    }
  }
  interface.others().clear();
}

// The one before it was not taken, or did not come at all.
void GlobalDataExchange::Packet::arrive(const std::vector<std::uint8_t>& telegram) {
  const std::uint16_t itsNumber = numberOf(telegram);
  const bool begins = (telegram[3] & kRestarted) != 0;
  const bool gap = expected && !begins && itsNumber != *expected;
  lost = fresh || gap;
  otherStart = (fresh && otherStart) || begins;
  fresh = true;
  expected = static_cast<std::uint16_t>((itsNumber + 1) % kNumbers);
  data.assign(telegram.begin() + kGlobalHead, telegram.end());
}

std::uint32_t GlobalDataExchange::take(cpu::Cpu& cpu, Packet& packet) const {
  if (!std::exchange(packet.fresh, false)) return 0;
  std::uint32_t bits = packet.lost ? gds::kLost : 0;
  if (packet.otherStart) bits |= gds::kSenderRestarted;
  if (packet.data.size() != packet.row.data.length) return bits | gds::kOtherLength;
  const Region region = globalRegion(cpu, packet.row.data, Access::Write);
  if (!region)
    return bits | (region.error == ErrorCode::DbMissing ? gds::kReceiverDb : gds::kReceiverLength);
  std::ranges::copy(packet.data, region.data);
  return bits | gds::kNewData;
}

std::uint32_t GlobalDataExchange::send(cpu::Cpu& cpu, Packet& packet,
                                       BasicCommunication& interface) const {
  if (++packet.cycles < packet.row.rate) return 0;
  packet.cycles = 0;
  const Region region = globalRegion(cpu, packet.row.data, Access::Read);
  if (!region) return region.error == ErrorCode::DbMissing ? gds::kSenderDb : gds::kSenderLength;
  const std::uint16_t number =
      std::exchange(packet.number, static_cast<std::uint16_t>((packet.number + 1) % kNumbers));
  std::vector<std::uint8_t> data = {
      static_cast<std::uint8_t>(kGlobal | number >> 7), packet.row.circle, packet.row.packet,
      static_cast<std::uint8_t>((packet.restarted ? kRestarted : 0) | (number & 0x7F))};
  data.insert(data.end(), region.data, region.data + region.length);
  packet.restarted = false;
  interface.sendToAll(std::move(data), cpu.machine().clock);
  return 0;
}

void GlobalDataExchange::exchange(cpu::Cpu& cpu, BasicCommunication& interface) {
  sort(interface);
  std::uint32_t all = 0;
  for (Packet& packet : packets_) {
    const std::uint32_t bits = packet.row.sends ? send(cpu, packet, interface) : take(cpu, packet);
    addBits(cpu, packet.row.status, bits);
    all |= bits;
  }
  addBits(cpu, groupStatus_, all);
}

void GlobalDataExchange::rest(BasicCommunication& interface) {
  interface.others().clear();
  for (Packet& packet : packets_) {
    packet.fresh = false;
    packet.expected.reset();
    packet.cycles = 0;
    packet.restarted = true;
  }
}

}  // namespace merker::system
