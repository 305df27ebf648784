#include "s7comm/block_receivers.h"

#include <utility>

namespace merker::s7comm {

void BlockReceivers::set(const Receiver& receiver) {
  if (receiver.removed) receivers_.erase(receiver.rid);
  if (receiver.removed) return;
  if (!receivers_.contains(receiver.rid) && receivers_.size() >= kMost) return;
  One& one = receivers_[receiver.rid];
  one.enabled = receiver.enabled;
  one.room = receiver.octets;
  if (receiver.enabled) one.full = false;
}

void BlockReceivers::interruptOne(One& one) {
  one.sequence = 0;
  one.octets.clear();
}

void BlockReceivers::interrupt() {
  for (auto& [rid, one] : receivers_) interruptOne(one);
}

// For its receiver, which is told; its sender gets a negative acknowledgement.
bool BlockReceivers::isTooLong(const One& one, const Segment& segment) {
  const std::size_t total = segment.total.value_or(0);
  return one.enabled && !one.full && total > one.room && total <= kLongestTelegram;
}

// A first segment begins anew, whatever had begun before: its sender has given that up.
Error BlockReceivers::append(One& one, const Segment& segment) {
  if (!one.enabled) return Error::BlockDisabled;
  if (one.full) return Error::WrongObjectState;
  if (segment.total) {
    sequence_ = static_cast<std::uint8_t>(sequence_ % 0xFF + 1);  // never 0
    one.sequence = sequence_;
    one.total = *segment.total;
    one.octets.clear();
  } else if (one.sequence == 0 || segment.sequence != one.sequence) {
    return Error::WrongSequence;
  }
  const std::size_t octets = one.octets.size() + segment.octets.size();
  if (one.total > kLongestTelegram || octets > one.total || segment.last != (octets == one.total))
    return Error::WrongPduSize;
  one.octets.insert(one.octets.end(), segment.octets.begin(), segment.octets.end());
  return Error::None;
}

BlockReceivers::Taken BlockReceivers::take(const Segment& segment) {
  const auto found = receivers_.find(segment.rid);
  if (found == receivers_.end()) return {{0, Error::NoSuchObject}};
  One& one = found->second;
  if (isTooLong(one, segment)) {
    interruptOne(one);
    one.full = true;
    return {.answer = {0, Error::WrongPduSize}, .whole = Telegram{segment.rid, {}, true}};
  }
  const Error error = append(one, segment);
  if (error != Error::None) {
    if (!one.full) one.sequence = 0;
    return {{0, error}};
  }
  Taken taken{.answer = {one.sequence, Error::None}, .octets = one.octets.size()};
  if (!segment.last) return taken;
  one.full = true;
  one.sequence = 0;
  taken.whole = Telegram{segment.rid, std::exchange(one.octets, {})};
  return taken;
}

}  // namespace merker::s7comm
