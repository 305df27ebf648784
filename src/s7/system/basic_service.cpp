// What the CPU does for its partners: accepts connections and data, reads and writes variables.
#include <algorithm>
#include <utility>

#include "system/arguments.h"

namespace merker::system {
namespace {

using cpu::Access;
using cpu::ErrorCode;

// Blocks of data that wait for SFC 66; each sender has at most one on the way.
constexpr std::size_t kLongestQueue = 32, kMostWishes = 32;

std::uint32_t codeOf(ErrorCode error) {
  switch (error) {
    case ErrorCode::None:
      return 0;
    case ErrorCode::DbMissing:
      return basic::kNoObject;
    case ErrorCode::ProtectedDb:
      return basic::kReadOnly;
    case ErrorCode::LengthRead:
    case ErrorCode::LengthWrite:
      return basic::kBadLength;
    default:
      return basic::kBadType;
  }
}

// E, A, M and data blocks with their number: a partner knows no open block and no local data.
bool isReachable(const AnyPointer& any) {
  const Area area = pointerArea(any.pointer);
  if (area == Area::DataBlock) return any.db != 0;
  return area == Area::Input || area == Area::Output || area == Area::Flag;
}

// A single bit travels as a byte.
bool isBit(const AnyPointer& any) { return any.type == TypeCode::Bool && any.count == 1; }

Region place(cpu::Cpu& cpu, AnyPointer any, Access access) {
  if (isBit(any)) any.pointer &= ~7u;
  return regionOf(cpu.machine(), any, byteCount(any), access);
}

}  // namespace

void BasicCommunication::answer(std::uint8_t to, std::uint16_t job, std::uint32_t code, Instant now,
                                std::vector<std::uint8_t> data) {
  send(to, {MessageKind::Answer, job, static_cast<std::uint16_t>(code), 0, {}, std::move(data)},
       now);
}

void BasicCommunication::finishOldest(std::uint32_t code, Instant now) {
  answer(queue_.front().from, queue_.front().job, code, now);
  queue_.pop_front();
}

void BasicCommunication::receive(Instant now) {
  while (node_ != nullptr) {
    auto telegram = node_->receive(now);
    if (!telegram) return;
    if (telegram->data.empty()) {
      over(telegram->from, basic::kUnreachable);
      others_.push_back(std::move(*telegram));
    } else if (auto message = decodeBasicMessage(telegram->data)) {
      handle(telegram->from, std::move(*message), now);
    } else {
      others_.push_back(std::move(*telegram));
    }
  }
}

void BasicCommunication::handle(std::uint8_t from, BasicMessage message, Instant now) {
  const auto link = links_.find(from);
  const bool mine =
      link != links_.end() && link->second.job && link->second.job->job == message.job;
  const bool known = partners_.contains(from);
  switch (message.kind) {
    case MessageKind::Connect:
      return connect(from, message, now);
    case MessageKind::Accept:
      if (!mine) return;
      link->second.connected = true;
      return send(from, *link->second.job, now);
    case MessageKind::Refuse:
    case MessageKind::Answer:
      if (mine) over(from, message.code, std::move(message.data));
      return;
    case MessageKind::End:
      return end(from);
    case MessageKind::Send:
      if (!known || stopped_ || queue_.size() >= kLongestQueue)
        return answer(from, message.job,
                      !known     ? basic::kBroken
                      : stopped_ ? basic::kStopped
                                 : basic::kPartnerFull,
                      now);
      queue_.push_back({from, message.job, message.id, std::move(message.data)});
      return;
    case MessageKind::Get:
    case MessageKind::Put:
      if (!known || wishes_.size() >= kMostWishes)
        return answer(from, message.job, known ? basic::kPartnerFull : basic::kBroken, now);
      wishes_.push_back({from, std::move(message)});
      return;
  }
}

void BasicCommunication::connect(std::uint8_t from, const BasicMessage& message, Instant now) {
  if (!partners_.contains(from) && full())
    return send(from, {MessageKind::Refuse, message.job, basic::kPartnerFull}, now);
  partners_.insert(from);
  send(from, {MessageKind::Accept, message.job}, now);
}

// What the partner sent over this connection is discarded, but for a block that is oldest and that
// the program has seen (manual, SFC 66).
void BasicCommunication::end(std::uint8_t from) {
  partners_.erase(from);
  const bool keepFirst = !queue_.empty() && queue_.front().seen;
  const auto first = queue_.begin() + (keepFirst ? 1 : 0);
  queue_.erase(
      std::remove_if(first, queue_.end(), [&](const Received& one) { return one.from == from; }),
      queue_.end());
  std::erase_if(wishes_, [&](const Wish& wish) { return wish.from == from; });
}

void BasicCommunication::fulfil(cpu::Cpu& cpu, const Wish& wish, Instant now) {
  const BasicMessage& message = wish.message;
  const bool get = message.kind == MessageKind::Get;
  const std::uint32_t bytes = byteCount(message.there);
  const auto refuse = [&](std::uint32_t code) { answer(wish.from, message.job, code, now); };
  if (bytes == 0 || !isReachable(message.there)) return refuse(basic::kBadType);
  if (get && bytes > kLongest) return refuse(basic::kTooLong);
  if (!get && bytes != message.data.size()) return refuse(basic::kBadLength);
  const Region region = place(cpu, message.there, get ? Access::Read : Access::Write);
  if (!region) return refuse(codeOf(region.error));
  const unsigned bit = message.there.pointer & 7;
  if (!isBit(message.there)) {
    if (get) return answer(wish.from, message.job, 0, now, {region.data, region.data + bytes});
    std::ranges::copy(message.data, region.data);
  } else if (get) {
    return answer(wish.from, message.job, 0, now,
                  {static_cast<std::uint8_t>(*region.data >> bit & 1)});
  } else {
    const auto mask = static_cast<std::uint8_t>(1u << bit);
    *region.data = static_cast<std::uint8_t>((message.data[0] & 1) != 0 ? *region.data | mask
                                                                        : *region.data & ~mask);
  }
  refuse(0);
}

void BasicCommunication::serve(cpu::Cpu& cpu, Instant now) {
  stopped_ = false;
  receive(now);
  for (; !wishes_.empty(); wishes_.pop_front()) fulfil(cpu, wishes_.front(), now);
}

// STOP ends the connections of this CPU and refuses what is in the queue (manual, SFC 65 to 67).
// What arrives now is answered at the instant at which it does.
void BasicCommunication::rest(cpu::Cpu& cpu, Instant now, bool powered) {
  if (node_ == nullptr) return;
  if (!powered) {
    while (node_->receive(now)) continue;
    restart();
    partners_.clear();
    return;
  }
  if (!std::exchange(stopped_, true)) {
    for (const auto& [partner, link] : links_)
      if (link.connected) send(partner, {MessageKind::End, lastJob_}, now);
    links_.clear();
    while (!queue_.empty())
      finishOldest(queue_.front().seen ? basic::kNotTaken : basic::kStopped, now);
  }
  receive(now);
  for (; !wishes_.empty(); wishes_.pop_front()) fulfil(cpu, wishes_.front(), now);
}

}  // namespace merker::system
