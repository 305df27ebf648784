#include "network/subnet.h"

#include <algorithm>

namespace merker::network {
namespace {

// How long the sender waits for the acknowledgement of an address, and how often it tries again:
// MPI_TSL = 415 of STEP 7's subnets, one repetition.
constexpr std::int64_t kSlotTime = 415, kTries = 2;

}  // namespace

Node& Subnet::add(std::uint8_t address) {
  const auto place = std::ranges::lower_bound(nodes_, address, {},
                                              [](const auto& node) { return node->address(); });
  return **nodes_.insert(place, std::make_unique<Node>(address));
}

Duration Subnet::duration(std::int64_t bits) const {
  constexpr std::int64_t kSecond = 1'000'000'000;
  return {(bits * kSecond + medium_.rate - 1) / medium_.rate};
}

Node* Subnet::find(std::uint8_t address) {
  const auto found =
      std::ranges::find(nodes_, address, [](const auto& node) { return node->address(); });
  return found == nodes_.end() ? nullptr : found->get();
}

Instant Subnet::occupy(Instant from, std::int64_t bits) {
  const Duration length = duration(bits);
  if (medium_.inTurns) return from + length;
  free_ = std::max(free_, from) + length;
  busy_ = busy_ + length;
  return free_;
}

void Subnet::mend() {
  interrupted_ = false;
  pulled_.clear();
  delay_ = {};
}

bool Subnet::reaches(std::uint8_t from, std::uint8_t to) const {
  return !interrupted_ && !pulled_.contains(from) && !pulled_.contains(to);
}

void Subnet::deliver(Node& node, Telegram telegram) {
  telegram.at = arrived_ = std::max(arrived_, telegram.at + medium_.latency + delay_);
  node.deliver(std::move(telegram));
}

void Subnet::put(Telegram telegram) {
  const std::int64_t bits = telegramBits(medium_, telegram.data.size());
  Node* const receiver = find(telegram.to);
  if (telegram.to == kEveryone) {
    telegram.at = occupy(telegram.at, bits);
    for (const auto& node : nodes_)
      if (node->address() != telegram.from && reaches(telegram.from, node->address()))
        deliver(*node, telegram);
  } else if (receiver != nullptr && reaches(telegram.from, telegram.to)) {
    telegram.at = occupy(telegram.at, bits);
    deliver(*receiver, std::move(telegram));
  } else if (medium_.acknowledged) {
    const Instant end = occupy(telegram.at, kTries * (bits + kSlotTime));
    deliver(*find(telegram.from), {end, telegram.to, telegram.from, {}});
  }
}

void Subnet::carry(Instant end) {
  std::vector<Telegram> sent;
  for (const auto& node : nodes_)
    for (Telegram& telegram : node->takeSent(end)) sent.push_back(std::move(telegram));
  std::ranges::stable_sort(sent, {}, &Telegram::at);
  for (Telegram& telegram : sent) put(std::move(telegram));
}

}  // namespace merker::network
