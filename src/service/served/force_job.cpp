#include "served/force_job.h"

#include <algorithm>

#include "base/bytes.h"
#include "served/values.h"

namespace merker::served {
namespace {

using s7comm::Error;
using s7comm::ItemCode;
using s7comm::TestItem;

TestItem itemOf(const monitor::Forced& one) {
  const address::Operand& operand = one.operand.operand;
  const bool bit = operand.width == Width::Bit;
  TestItem item;
  item.range = {.memory = static_cast<s7comm::Memory>(operand.area),
                .begin = operand.value / 8,
                .octets = bit ? 1u : byteCount(operand.width),
                .bit = static_cast<std::uint8_t>(bit ? operand.value % 8 : 0),
                .oneBit = bit};
  for (std::uint32_t i = item.range.octets; i-- > 0;)
    item.value.push_back(static_cast<std::uint8_t>(one.value >> (8 * i)));
  return item;
}

}  // namespace

s7comm::TestJob forceJobOf(const monitor::Monitor& monitor, std::uint8_t number) {
  std::vector<TestItem> items;
  for (const monitor::Forced& one : monitor.forces()) items.push_back(itemOf(one));
  return s7comm::forceJob(number, std::move(items));
}

Error forceAll(monitor::Monitor& monitor, const std::vector<TestItem>& items) {
  std::vector<s7comm::Write> writes;
  for (const TestItem& item : items) {
    if (item.code != ItemCode::Done) return Error::WrongTestVariable;
    writes.push_back({item.range, item.value});
  }
  return force(monitor, writes) ? Error::None : Error::WrongTestVariable;
}

Error forceInstead(monitor::Monitor& monitor, const std::vector<TestItem>& items) {
  const s7comm::TestJob before = forceJobOf(monitor, 0);
  monitor.unforceAll();
  const Error error = forceAll(monitor, items);
  if (error != Error::None) forceAll(monitor, before.items);
  return error;
}

}  // namespace merker::served
