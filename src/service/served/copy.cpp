#include "served/copy.h"

#include <algorithm>

#include "served/values.h"

namespace merker::served {

using s7comm::Range;
using s7comm::Value;

std::optional<std::vector<Value>> valuesOf(const Copy& copy, std::span<const Range> ranges) {
  std::vector<Value> values;
  values.reserve(ranges.size());
  for (const Range& range : ranges) {
    if (isCopied(range)) {
      values.push_back(valueOf(copy.operands, range));
      continue;
    }
    const auto found =
        std::ranges::find(copy.periphery, range, [](auto& row) { return row.first; });
    if (found == copy.periphery.end()) return std::nullopt;
    values.push_back(found->second);
  }
  return values;
}

void PeripheryWatch::ask(std::span<const Range> ranges) {
  for (const Range& range : ranges) {
    if (isCopied(range)) continue;
    const auto found = std::ranges::find(asked_, range, &Asked::range);
    if (found != asked_.end())
      found->last.reset();
    else if (asked_.size() < kMost)
      asked_.push_back({range});
  }
}

void PeripheryWatch::copy(const controller::Controller& plc, Copy& copy) {
  const Instant now = plc.now();
  for (Asked& one : asked_)
    if (!one.last) one.last = now;
  std::erase_if(asked_, [&](const Asked& one) { return now - *one.last > kKept; });
  copy.periphery.clear();
  for (const Asked& one : asked_)
    copy.periphery.emplace_back(one.range, peripheralValue(plc, one.range));
}

}  // namespace merker::served
