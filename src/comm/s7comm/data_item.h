// Values as they stand in data: return code, transport size, length, octets. Each but the last one
// has an even number of octets; the one that fills up does not count in its length.
#pragma once

#include <optional>

#include "s7comm/item.h"

namespace merker::s7comm {

struct DataItem {
  ItemCode code = ItemCode::Requested;
  DataUnit unit = DataUnit::None;
  View octets{};
};

constexpr std::size_t kDataItemHeader = 4;

// Takes the next one off `bytes`. Nothing: it goes beyond them.
std::optional<DataItem> readDataItem(View& bytes);
// Behind the ones that are there.
void writeDataItem(Bytes& out, const DataItem& item);

// What the values of items take, one behind the other; counted before anything is read: 65535
// double words are counted, never allocated.
std::uint64_t dataItemOctets(std::span<const Wanted> items);
// A value for each range of them. Those of one item are one value; one that is not there refuses
// them all.
void writeValues(Bytes& out, std::span<const Wanted> items, const std::vector<Value>& values);
std::vector<Range> rangesOf(std::span<const Wanted> items);

}  // namespace merker::s7comm
