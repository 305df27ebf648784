#include "nc/flag_stack.h"

#include <algorithm>

namespace merker::nc {
namespace {

constexpr std::uint16_t kStackPointer = 1;

}  // namespace

Error FlagStack::push(const sinumerik::Machine& m) {
  if (saved_.size() >= depth_) return kStackPointer;
  std::copy_n(m.flags.begin() + kFirstTransferFlag, Flags{}.size(), saved_.emplace_back().begin());
  return std::nullopt;
}

Error FlagStack::pop(sinumerik::Machine& m) {
  if (saved_.empty()) return kStackPointer;
  std::copy(saved_.back().begin(), saved_.back().end(), m.flags.begin() + kFirstTransferFlag);
  saved_.pop_back();
  return std::nullopt;
}

}  // namespace merker::nc
