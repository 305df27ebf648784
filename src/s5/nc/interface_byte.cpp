#include "nc/interface_byte.h"

#include "nc/plc_memory.h"

namespace merker::nc {
namespace {

constexpr std::uint16_t kInterfaceBlock = 36;
constexpr std::uint8_t kLoadLeft = 0x22, kLoadRight = 0x2A;

}  // namespace

std::optional<unsigned> interfaceNumber(std::uint16_t code) {
  const unsigned left = lowByte(code) * 2u + 1;
  const unsigned number = highByte(code) == kLoadLeft    ? left
                          : highByte(code) == kLoadRight ? left + 1
                                                         : 0;
  if (number == 0 || number > kInterfaceBytes) return std::nullopt;
  return number;
}

InterfaceByte::InterfaceByte(sinumerik::Machine& machine, unsigned number)
    : shift_(number % 2 == 1 ? 8 : 0) {
  const auto words = dataBlock(machine, kInterfaceBlock);
  const unsigned word = (number - 1) / 2;
  if (number >= 1 && word < words.size()) word_ = &words[word];
}

void InterfaceByte::set(unsigned bit, bool on) {
  if (!exists()) return;
  const auto mask = static_cast<std::uint16_t>(1u << (shift_ + bit));
  *word_ = static_cast<std::uint16_t>(on ? *word_ | mask : *word_ & ~mask);
}

}  // namespace merker::nc
