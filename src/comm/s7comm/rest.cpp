#include "s7comm/rest.h"

#include <algorithm>

namespace merker::s7comm {

std::uint8_t Rests::number() {
  last_ = static_cast<std::uint8_t>(last_ % 0xFF + 1);
  end(last_);
  lost_[last_] = false;
  return last_;
}

void Rests::keep(Rest rest) {
  if (rests_.size() == kMost) {
    lost_[rests_.front().sequence] = true;
    rests_.pop_front();
  }
  rests_.push_back(std::move(rest));
}

Rest* Rests::find(std::uint8_t sequence) {
  const auto found = std::ranges::find(rests_, sequence, &Rest::sequence);
  return found == rests_.end() ? nullptr : &*found;
}

void Rests::end(std::uint8_t sequence) {
  std::erase_if(rests_, [sequence](const Rest& one) { return one.sequence == sequence; });
}

}  // namespace merker::s7comm
