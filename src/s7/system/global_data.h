// Global data (S7-NET-27): at the end of a cycle a CPU takes the packets that have come, and sends
// its own in every cycle of the reduction factor. Nobody acknowledges them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "network/global_data.h"
#include "system/basic_communication.h"

namespace merker::system {

// Bits of GDS and GST; the program resets them.
namespace gds {
constexpr std::uint32_t kSenderLength = 1u << 0, kSenderDb = 1u << 1, kLost = 1u << 3;
constexpr std::uint32_t kOtherLength = 1u << 6, kReceiverLength = 1u << 7, kReceiverDb = 1u << 8;
constexpr std::uint32_t kSenderRestarted = 1u << 11, kNewData = 1u << 31;
}  // namespace gds

class GlobalDataExchange {
 public:
  GlobalDataExchange() = default;
  explicit GlobalDataExchange(const network::GlobalData& data);
  bool empty() const { return packets_.empty() && !groupStatus_; }

  // At a cycle checkpoint.
  void exchange(cpu::Cpu& cpu, BasicCommunication& interface);
  // In STOP nothing is exchanged; after it the first packets say so.
  void rest(BasicCommunication& interface);

 private:
  struct Packet {
    network::GlobalPacket row;
    std::uint32_t cycles = 0;               // since it was sent
    bool restarted = true;                  // it was not sent since then
    std::uint16_t number = 0;               // of the next one that is sent
    std::optional<std::uint16_t> expected;  // the number of the next one that comes
    std::vector<std::uint8_t> data;         // what has come
    bool fresh = false, lost = false;       // it has come; another one before it was not taken
    bool otherStart = false;                // the sender was restarted

    void arrive(const std::vector<std::uint8_t>& telegram);
  };
  void sort(BasicCommunication& interface);
  std::uint32_t take(cpu::Cpu& cpu, Packet& packet) const;
  std::uint32_t send(cpu::Cpu& cpu, Packet& packet, BasicCommunication& interface) const;

  std::vector<Packet> packets_;
  std::optional<network::GlobalArea> groupStatus_;
};

}  // namespace merker::system
