#include "s7comm/data_item.h"

#include <algorithm>

#include "base/bytes.h"

namespace merker::s7comm {

std::optional<DataItem> readDataItem(View& bytes) {
  if (bytes.size() < kDataItemHeader) return std::nullopt;
  // An item that has failed has no value; some servers say a length all the same.
  const bool none = bytes[1] == static_cast<std::uint8_t>(DataUnit::None);
  const std::uint32_t length = none ? 0 : octets(bytes[1], loadWord(&bytes[2]));
  const View rest = bytes.subspan(kDataItemHeader);
  if (rest.size() < length) return std::nullopt;
  const DataItem item{.code = static_cast<ItemCode>(bytes[0]),
                      .unit = static_cast<DataUnit>(bytes[1]),
                      .octets = rest.first(length)};
  bytes = rest.subspan(std::min<std::size_t>(rest.size(), length + length % 2));
  return item;
}

void writeDataItem(Bytes& out, const DataItem& item) {
  if (out.size() % 2 != 0) out.push_back(0);
  const auto count = static_cast<std::uint32_t>(item.octets.size());
  out.insert(out.end(),
             {static_cast<std::uint8_t>(item.code), static_cast<std::uint8_t>(item.unit)});
  appendWord(out, item.unit == DataUnit::None ? 0 : lengthField(item.unit, count));
  out.insert(out.end(), item.octets.begin(), item.octets.end());
}

std::uint64_t dataItemOctets(std::span<const Wanted> items) {
  std::uint64_t size = 0;
  for (const Wanted& item : items) {
    size += size % 2 + kDataItemHeader;
    if (item.code == ItemCode::Done) size += item.octets();
    if (item.coded) size += item.ranges.size();
  }
  return size;
}

static void writeValue(Bytes& out, const Wanted& item, std::vector<Value>::const_iterator& value) {
  ItemCode code = item.code;
  Bytes octets;
  for (std::size_t i = 0; i < item.ranges.size(); ++i, ++value) {
    if (item.coded) octets.push_back(static_cast<std::uint8_t>(value->code));
    if (value->code != ItemCode::Done && !item.coded && code == ItemCode::Done) code = value->code;
    octets.insert(octets.end(), value->octets.begin(), value->octets.end());
  }
  if (code == ItemCode::Done) return writeDataItem(out, {code, item.unit, octets});
  writeDataItem(out, {code, DataUnit::None, {}});
}

void writeValues(Bytes& out, std::span<const Wanted> items, const std::vector<Value>& values) {
  auto value = values.begin();
  for (const Wanted& item : items) writeValue(out, item, value);
}

std::vector<Range> rangesOf(std::span<const Wanted> items) {
  std::vector<Range> ranges;
  for (const Wanted& item : items)
    ranges.insert(ranges.end(), item.ranges.begin(), item.ranges.end());
  return ranges;
}

}  // namespace merker::s7comm
