// The telegrams of S7 basic communication (SFC 65 to 69) between two CPUs, as bytes. Their form is
// our own (docs/compatibility.md); their length decides how long the line is busy.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "system/any_pointer.h"

namespace merker::system {

enum class MessageKind : std::uint8_t { Connect = 1, Accept, Refuse, End, Send, Get, Put, Answer };

struct BasicMessage {
  MessageKind kind = MessageKind::Connect;
  std::uint16_t job = 0;   // of the CPU that asked; the answer has the same
  std::uint16_t code = 0;  // Answer, Refuse: what RET_VAL becomes
  std::uint32_t id = 0;    // Send: REQ_ID
  AnyPointer there{};      // Get, Put: the variable at the partner
  std::vector<std::uint8_t> data{};
};

std::vector<std::uint8_t> encode(const BasicMessage& message);
// Nothing: it is none.
std::optional<BasicMessage> decodeBasicMessage(std::span<const std::uint8_t> bytes);

}  // namespace merker::system
