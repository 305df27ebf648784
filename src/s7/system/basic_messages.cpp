#include "system/basic_messages.h"

#include "base/bytes.h"

namespace merker::system {
namespace {

constexpr std::size_t kHead = 9, kAny = 10;

bool hasVariable(MessageKind kind) { return kind == MessageKind::Get || kind == MessageKind::Put; }

void storeAny(std::uint8_t* at, const AnyPointer& any) {
  at[0] = any.syntax;
  at[1] = static_cast<std::uint8_t>(any.type);
  storeWord(at + 2, any.count);
  storeWord(at + 4, any.db);
  storeDWord(at + 6, any.pointer);
}

AnyPointer loadAny(const std::uint8_t* at) {
  return {.syntax = at[0],
          .type = static_cast<TypeCode>(at[1]),
          .count = loadWord(at + 2),
          .db = loadWord(at + 4),
          .pointer = loadDWord(at + 6)};
}

}  // namespace

std::vector<std::uint8_t> encode(const BasicMessage& message) {
  std::vector<std::uint8_t> bytes(kHead + (hasVariable(message.kind) ? kAny : 0));
  bytes[0] = static_cast<std::uint8_t>(message.kind);
  storeWord(&bytes[1], message.job);
  storeWord(&bytes[3], message.code);
  storeDWord(&bytes[5], message.id);
  if (hasVariable(message.kind)) storeAny(&bytes[kHead], message.there);
  bytes.insert(bytes.end(), message.data.begin(), message.data.end());
  return bytes;
}

std::optional<BasicMessage> decodeBasicMessage(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kHead || bytes[0] < static_cast<std::uint8_t>(MessageKind::Connect) ||
      bytes[0] > static_cast<std::uint8_t>(MessageKind::Answer))
    return std::nullopt;
  BasicMessage message;
  message.kind = static_cast<MessageKind>(bytes[0]);
  message.job = loadWord(&bytes[1]);
  message.code = loadWord(&bytes[3]);
  message.id = loadDWord(&bytes[5]);
  std::size_t head = kHead;
  if (hasVariable(message.kind)) {
    if (bytes.size() < kHead + kAny) return std::nullopt;
    message.there = loadAny(&bytes[kHead]);
    head += kAny;
  }
  message.data.assign(bytes.begin() + static_cast<std::ptrdiff_t>(head), bytes.end());
  return message;
}

}  // namespace merker::system
