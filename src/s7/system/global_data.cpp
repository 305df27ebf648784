#include "system/global_data.h"

#include <algorithm>
#include <utility>

#include "base/bytes.h"
#include "system/arguments.h"

namespace merker::system {
namespace {

using cpu::Access;
using cpu::ErrorCode;

// In front of the data on the line: what it is, circle, packet, whether the sender was restarted.
constexpr std::uint8_t kGlobal = 0x47;
constexpr std::size_t kGlobalHead = 4;

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
    if (telegram.data.size() < kGlobalHead || telegram.data[0] != kGlobal) continue;
    for (Packet& packet : packets_) {
      if (packet.row.sends || packet.row.circle != telegram.data[1] ||
          packet.row.packet != telegram.data[2])
        continue;
      const bool restarted = packet.fresh && packet.data[3] != 0;
      packet.data = telegram.data;
      if (restarted) packet.data[3] = 1;
      packet.lost = packet.fresh;
      packet.fresh = true;
    }
  }
  interface.others().clear();
}

std::uint32_t GlobalDataExchange::take(cpu::Cpu& cpu, Packet& packet) const {
  if (!std::exchange(packet.fresh, false)) return 0;
  std::uint32_t bits = packet.lost ? gds::kLost : 0;
  if (packet.data[3] != 0) bits |= gds::kSenderRestarted;
  if (packet.data.size() - kGlobalHead != packet.row.data.length) return bits | gds::kOtherLength;
  const Region region = globalRegion(cpu, packet.row.data, Access::Write);
  if (!region)
    return bits | (region.error == ErrorCode::DbMissing ? gds::kReceiverDb : gds::kReceiverLength);
  std::copy(packet.data.begin() + kGlobalHead, packet.data.end(), region.data);
  return bits | gds::kNewData;
}

std::uint32_t GlobalDataExchange::send(cpu::Cpu& cpu, Packet& packet,
                                       BasicCommunication& interface) const {
  if (++packet.cycles < packet.row.rate) return 0;
  packet.cycles = 0;
  const Region region = globalRegion(cpu, packet.row.data, Access::Read);
  if (!region) return region.error == ErrorCode::DbMissing ? gds::kSenderDb : gds::kSenderLength;
  std::vector<std::uint8_t> data = {kGlobal, packet.row.circle, packet.row.packet,
                                    static_cast<std::uint8_t>(packet.restarted ? 1 : 0)};
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
    packet.cycles = 0;
    packet.restarted = true;
  }
}

}  // namespace merker::system
