// Cyclic reads (group 2): values that the PLC sends by itself, at an interval (01) or only when
// they have changed (05). Their job has the sequence number of the first answer and of all
// indications. Layout: Wireshark's dissector; errors: SIMATIC's list of D8xx.
#include <algorithm>

#include "base/bytes.h"
#include "s7comm/data_item.h"
#include "s7comm/userdata.h"

namespace merker::s7comm {
namespace {

constexpr std::uint8_t kCyclic = 0x01, kOnChange = 0x05;
constexpr std::size_t kCyclicHead = 4;                    // count, base, factor
constexpr std::uint32_t kBases[] = {100, 1'000, 10'000};  // milliseconds

// What is sent has its count before it.
Bytes cyclicData(std::span<const Wanted> items, const std::vector<Value>& values) {
  Bytes data;
  appendWord(data, static_cast<std::uint32_t>(items.size()));
  writeValues(data, items, values);
  return data;
}

// On change an S7-400 answers a DBREAD item with octets, the code of each area in front of it (seen
// of its talk with WinCC: areas of 5, 29 and 22 octets are 59).
void codeAreas(Wanted& item) {
  if (!item.areas) return;
  item.coded = true;
  item.unit = DataUnit::Octets;
}

// The items of a request; nothing, and why.
std::optional<std::vector<Wanted>> cyclicItems(const Request& request, Error& error) {
  View bytes = request.data;
  error = Error::WrongPduSize;
  if (bytes.size() < kCyclicHead) return std::nullopt;
  const std::size_t count = loadWord(&bytes[0]);
  bytes = bytes.subspan(kCyclicHead);
  auto items = readItems(bytes, count);
  if (!items || items->empty()) return std::nullopt;
  if (request.subfunction != kCyclic) std::ranges::for_each(*items, codeAreas);
  if (2 + dataItemOctets(*items) > request.job.outlet()->room()) return std::nullopt;
  error = Error::WrongVariable;
  const bool good =
      std::ranges::all_of(*items, [](const Wanted& item) { return item.code == ItemCode::Done; });
  return good ? std::move(items) : std::nullopt;
}

// Nothing: there is no such base, or no factor.
std::optional<std::uint32_t> intervalOf(View head) {
  const std::size_t base = head[2];
  if (base >= std::size(kBases) || head[3] == 0) return std::nullopt;
  return kBases[base] * head[3];
}

void beginReading(const Request& request, std::optional<std::uint8_t> number,
                  std::uint8_t subfunction) {
  Error error = Error::None;
  auto items = cyclicItems(request, error);
  if (!items) return request.refuse(error);
  const auto interval = intervalOf(request.data);
  if (!interval) return request.refuse(Error::WrongInterval);
  const auto ranges = rangesOf(*items);
  const auto data = [items = std::move(*items)](const std::vector<Value>& values) {
    return cyclicData(items, values);
  };
  request.job.plc().subscribe(request.job.outlet(), number,
                              {subfunction, subfunction == kOnChange, *interval, ranges, data},
                              [begun = request.begun(), data](Error why, std::uint8_t job,
                                                              const std::vector<Value>& values) {
                                why == Error::None ? begun.answerAs(job, data(values))
                                                   : begun.refuse(why);
                                begun.ended();
                              });
}

}  // namespace

void serveSubscribe(const Request& request) {
  beginReading(request, std::nullopt, request.subfunction);
}

// The job is the one of the sequence number.
void serveModifySubscription(const Request& request) {
  beginReading(request, request.sequence, kOnChange);
}

// Function, number of the job.
void serveUnsubscribe(const Request& request) {
  if (request.data.size() != 2) return request.refuse(Error::WrongPduSize);
  request.job.plc().unsubscribe(request.job.outlet(), request.data[1],
                                [begun = request.begun()](Error error) {
                                  error == Error::None ? begun.done() : begun.refuse(error);
                                  begun.ended();
                                });
}

}  // namespace merker::s7comm
