// The screens of 8.2 as text.
#include <fmt/format.h>

#include <array>

#include "softplc/interrupt_stack.h"

namespace merker::sinumerik {
namespace {

constexpr std::array<std::string_view, 8> kDisplays{"ERAB",  "VKE",  "STATUS", "ODER",
                                                    "OVFLS", "OVFL", "ANZ0",   "ANZ1"};

std::string blockText(const std::optional<mc5::BlockId>& id) { return id ? toString(*id) : "-"; }

std::string dataText(const std::optional<std::uint16_t>& number) {
  return number ? fmt::format("DB {}", *number) : "-";
}

std::string akku(std::uint32_t value) {
  return fmt::format("{:04X} {:04X}", value >> 16, value & 0xFFFF);
}

std::string displayText(std::uint8_t displays) {
  std::string text;
  for (std::size_t bit = kDisplays.size(); bit-- > 0;)
    text += fmt::format(" {}={}", kDisplays[bit], displays >> bit & 1);
  return text;
}

std::string causeText(const Causes& causes) {
  std::string text;
  for (auto cause = Cause::STOPS; cause <= Cause::TRAF;
       cause = static_cast<Cause>(static_cast<int>(cause) + 1))
    text += fmt::format(" {}={}", name(cause), causes.test(cause) ? 1 : 0);
  return text;
}

}  // namespace

std::string toString(const InterruptStack& s) {
  return fmt::format(
      "TIEFE: {:02}\n"
      "BEF-REG: {:04X}  SAZ: {:04X}  DB-ADR: {:04X}  BA-ADR: {:04X}\n"
      "BST-STP: {:04X}  XX-NR.: {}  DB-NR.: {}  YY-NR.: {}\n"
      "REL-SAZ: {:04X}  DBL-REG: {:04X}\n"
      "VEK-ADR: 0000  UAMK: {:04X}\n"
      "AKKU1: {}  AKKU2: {}\n"
      "ERGEBNISANZEIGE:{}\n"
      "STÖRUNGSURSACHE:{}\n",
      s.depth, s.instruction, s.stepAddress, s.dataAddress, s.blockAddress, s.blockStackPointer,
      blockText(s.block), dataText(s.dataBlock), blockText(s.caller), s.relativeStep, s.dataLength,
      s.controlRegister, akku(s.akku1), akku(s.akku2), displayText(s.displays),
      causeText(s.causes));
}

std::string toString(const std::vector<BlockStackEntry>& stack) {
  std::string text;
  for (const BlockStackEntry& entry : stack)
    text += fmt::format("{:<7} ADR {:04X}  REL {:04X}  {}\n", toString(entry.block),
                        entry.returnAddress, entry.relative, dataText(entry.dataBlock));
  return text;
}

}  // namespace merker::sinumerik
