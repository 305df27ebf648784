// 04h and 05h: read and write variables.
#include <algorithm>

#include "s7comm/data_item.h"
#include "s7comm/services.h"

namespace merker::s7comm {
namespace {

constexpr std::size_t kFunctionAndCount = 2;

using Items = std::vector<Wanted>;

// Nothing: the parameters are not what they say.
std::optional<Items> itemsOf(const Job& job) {
  View bytes = job.parameters.subspan(1);
  if (bytes.empty() || bytes[0] == 0) return std::nullopt;
  const std::size_t count = bytes[0];
  bytes = bytes.subspan(1);
  return readItems(bytes, count);
}

void refuseVariables(const Job& job, Error error) {
  const std::uint8_t parameters[] = {job.function, 0};
  job.answer(parameters, {}, error);
}

bool fits(const Items& items, std::size_t pdu) {
  return kAnswerHeader + kFunctionAndCount + dataItemOctets(items) <= pdu;
}

void answerRead(const Job& job, const Items& items, const std::vector<Value>& values) {
  Bytes data;
  writeValues(data, items, values);
  const std::uint8_t parameters[] = {job.function, static_cast<std::uint8_t>(items.size())};
  job.answer(parameters, data);
  job.ended();
}

// What one item is to become: refused here, or a write for the PLC.
ItemCode toWrite(const Wanted& item, const DataItem& value, std::vector<Write>& writes) {
  if (item.code != ItemCode::Done) return item.code;
  if (item.ranges.size() != 1) return ItemCode::TypeNotSupported;  // DBREAD
  if (value.octets.size() != item.octets()) return ItemCode::TypeMismatch;
  writes.push_back({item.ranges[0], Bytes(value.octets.begin(), value.octets.end())});
  return ItemCode::Done;
}

// `done` has a code for each item that was not refused before.
void answerWrite(const Job& job, std::vector<ItemCode> codes, const std::vector<ItemCode>& done) {
  auto next = done.begin();
  for (ItemCode& code : codes)
    if (code == ItemCode::Done) code = *next++;
  Bytes data(codes.size());
  std::ranges::transform(codes, data.begin(),
                         [](ItemCode code) { return static_cast<std::uint8_t>(code); });
  const std::uint8_t parameters[] = {job.function, static_cast<std::uint8_t>(codes.size())};
  job.answer(parameters, data);
  job.ended();
}

}  // namespace

void serveRead(const Job& job) {
  auto items = itemsOf(job);
  if (!items || !fits(*items, job.pdu())) return refuseVariables(job, Error::WrongPduSize);
  const std::vector<Range> ranges = rangesOf(*items);
  job.plc().read(
      ranges, [begun = job.begun(), items = std::move(*items)](const std::vector<Value>& values) {
        answerRead(begun, items, values);
      });
}

void serveWrite(const Job& job) {
  const auto items = itemsOf(job);
  if (!items) return refuseVariables(job, Error::WrongPduSize);
  std::vector<Write> writes;
  std::vector<ItemCode> codes;
  View data = job.data;
  for (const Wanted& item : *items) {
    const auto value = readDataItem(data);
    if (!value) return refuseVariables(job, Error::WrongPduSize);
    codes.push_back(toWrite(item, *value, writes));
  }
  job.plc().write(std::move(writes),
                  [begun = job.begun(), codes = std::move(codes)](
                      const std::vector<ItemCode>& done) { answerWrite(begun, codes, done); });
}

}  // namespace merker::s7comm
