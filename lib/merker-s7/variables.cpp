#include "variables.h"

#include <algorithm>
#include <cstring>

#include "s7comm/request.h"

namespace merker::s7client {
namespace {

using s7comm::AnyItem;
using s7comm::ItemCode;

constexpr std::size_t kMostItems = 20;  // S7-LIM-01

// Octets of a PDU that are no values: header, parameters and, of each item, what stands before its
// value.
constexpr std::size_t kReadAnswer = 18, kWriteRequest = 28;
constexpr std::size_t kItemAddress = 12, kItemHead = 4, kJobHead = 12, kAnswerHead = 14;

struct Code {
  std::uint16_t code;
  int error;
};
constexpr Code kItemCodes[] = {{0xFF, 0},
                               {0x03, errCliAddressOutOfRange},
                               {0x05, errCliAddressOutOfRange},
                               {0x06, errCliInvalidTransportSize},
                               {0x07, errCliWriteDataSizeMismatch},
                               {0x0A, errCliItemNotAvailable}};
constexpr Code kPduErrors[] = {{0x8104, errCliFunNotAvailable},
                               {0x8500, errCliSizeOverPDU},
                               {0xD241, errCliNeedPassword},
                               {0xDC01, errCliInvalidValue}};

template <std::size_t size>
int errorOf(const Code (&table)[size], std::uint16_t code) {
  for (const Code& row : table)
    if (row.code == code) return row.error;
  return errCliFunctionRefused;
}

int errorOf(ItemCode code) { return errorOf(kItemCodes, static_cast<std::uint16_t>(code)); }
int errorOf(const s7comm::Pdu& answer) {
  return answer.error == s7comm::Error::None
             ? static_cast<int>(errCliInvalidPlcAnswer)
             : errorOf(kPduErrors, static_cast<std::uint16_t>(answer.error));
}

bool isCell(int area) { return area == S7AreaTM || area == S7AreaCT; }

// Timers and counters are their own elements, whatever was said.
int wordLenOf(int area, int wordLen) { return isCell(area) ? area : wordLen; }

int check(const Elements& e) {
  constexpr int kAreas[] = {S7AreaPE, S7AreaPA, S7AreaMK, S7AreaDB, S7AreaCT, S7AreaTM};
  if (std::ranges::find(kAreas, e.area) == std::end(kAreas) || e.amount < 1 || e.start < 0)
    return errCliInvalidParams;
  const std::size_t bytes = elementBytes(wordLenOf(e.area, e.wordLen));
  if (bytes == 0 || (e.wordLen == S7WLBit && e.amount != 1)) return errCliInvalidWordLen;
  constexpr std::uint64_t kBitAddresses = 1 << 24, kMostBytes = 65'536;
  const std::uint64_t units = e.wordLen == S7WLBit || isCell(e.area) ? 1 : 8;
  const bool reachable = e.start * units < kBitAddresses && e.amount <= 65'535 / int(bytes) + 1 &&
                         e.amount * bytes <= kMostBytes && e.db >= 0 && e.db <= 65'535;
  return reachable ? 0 : static_cast<int>(errCliInvalidParams);
}

// Of `amount` elements, the first of them `skipped` bytes (or timers) behind the start.
AnyItem itemOf(const Elements& e, int skipped, int amount) {
  const bool raw = e.wordLen == S7WLBit || isCell(e.area);
  const auto start = static_cast<std::uint32_t>(e.start + skipped);
  return {.type = static_cast<s7comm::ElementType>(wordLenOf(e.area, e.wordLen)),
          .count = static_cast<std::uint16_t>(amount),
          .block = static_cast<std::uint16_t>(e.area == S7AreaDB ? e.db : 0),
          .memory = static_cast<s7comm::Memory>(e.area),
          .address = raw ? start : start * 8};
}

// Calls `part(item, first byte, bytes)` for as many elements as fit, until one fails.
template <typename Part>
int inParts(const Elements& e, std::size_t room, Part part) {
  if (const int error = check(e)) return error;
  const auto bytes = static_cast<int>(elementBytes(wordLenOf(e.area, e.wordLen)));
  const int most = std::max(static_cast<int>(room) / bytes, 1);
  for (int done = 0; done < e.amount;) {
    const int count = std::min(most, e.amount - done);
    const AnyItem item = itemOf(e, isCell(e.area) ? done : done * bytes, count);
    if (const int error = part(item, done * bytes, count * bytes)) return error;
    done += count;
  }
  return 0;
}

std::size_t roomIn(const Connection& connection, std::size_t overhead) {
  return connection.pdu() > overhead ? connection.pdu() - overhead : 0;
}

int readItems(Connection& connection, std::span<const AnyItem> items,
              std::vector<s7comm::Value>& values) {
  const std::uint16_t reference = connection.nextReference();
  s7comm::Pdu answer;
  if (const int error =
          connection.exchange(s7comm::readRequest(reference, items), reference, answer))
    return error;
  auto read = s7comm::readAnswer(answer);
  if (!read || read->size() != items.size()) return errorOf(answer);
  values = std::move(*read);
  return 0;
}

int writeItems(Connection& connection, std::span<const AnyItem> items,
               std::span<const s7comm::Bytes> values, std::vector<ItemCode>& codes) {
  const std::uint16_t reference = connection.nextReference();
  s7comm::Pdu answer;
  if (const int error = connection.exchange(s7comm::writeRequest(reference, items, values),
                                            reference, answer))
    return error;
  auto written = s7comm::writeAnswer(answer);
  if (!written || written->size() != items.size()) return errorOf(answer);
  codes = std::move(*written);
  return 0;
}

int copy(const s7comm::Value& value, std::size_t bytes, std::uint8_t* target) {
  if (const int error = errorOf(value.code)) return error;
  if (value.octets.size() != bytes) return errCliInvalidPlcAnswer;
  std::memcpy(target, value.octets.data(), bytes);
  return 0;
}

Elements elementsOf(const TS7DataItem& item) {
  return {item.Area, item.DBNumber, item.Start, item.Amount, item.WordLen};
}

std::size_t bytesOf(const TS7DataItem& item) {
  return static_cast<std::size_t>(item.Amount) * elementBytes(wordLenOf(item.Area, item.WordLen));
}

// Octets of a value in a PDU: filled up to an even number.
std::size_t even(std::size_t bytes) { return (bytes + 1) / 2 * 2; }

// The items, or why they cannot go in one PDU.
int itemsOf(std::span<const TS7DataItem> list, std::vector<AnyItem>& items, std::size_t& bytes) {
  if (list.empty()) return errCliInvalidParams;
  if (list.size() > kMostItems) return errCliTooManyItems;
  for (const TS7DataItem& item : list) {
    if (const int error = check(elementsOf(item))) return error;
    if (item.pdata == nullptr) return errCliInvalidParams;
    items.push_back(itemOf(elementsOf(item), 0, item.Amount));
    bytes += kItemHead + even(bytesOf(item));
  }
  return 0;
}

}  // namespace

std::size_t elementBytes(int wordLen) {
  switch (wordLen) {
    case S7WLBit:
    case S7WLByte:
    case S7WLChar: return 1;
    case S7WLWord:
    case S7WLInt:
    case S7WLCounter:
    case S7WLTimer: return 2;
    case S7WLDWord:
    case S7WLDInt:
    case S7WLReal: return 4;
    default: return 0;
  }
}

int read(Connection& connection, const Elements& elements, std::uint8_t* data) {
  const auto part = [&](const AnyItem& item, int first, int bytes) {
    std::vector<s7comm::Value> values;
    if (const int error = readItems(connection, {&item, 1}, values)) return error;
    return copy(values[0], static_cast<std::size_t>(bytes), data + first);
  };
  return inParts(elements, roomIn(connection, kReadAnswer), part);
}

int write(Connection& connection, const Elements& elements, const std::uint8_t* data) {
  const auto part = [&](const AnyItem& item, int first, int bytes) {
    const s7comm::Bytes value(data + first, data + first + bytes);
    std::vector<ItemCode> codes;
    if (const int error = writeItems(connection, {&item, 1}, {&value, 1}, codes)) return error;
    return errorOf(codes[0]);
  };
  return inParts(elements, roomIn(connection, kWriteRequest), part);
}

int readMany(Connection& connection, std::span<TS7DataItem> list) {
  std::vector<AnyItem> items;
  std::size_t bytes = 0;
  if (const int error = itemsOf(list, items, bytes)) return error;
  const std::size_t request = kJobHead + kItemAddress * items.size();
  if (std::max(kAnswerHead + bytes, request) > connection.pdu()) return errCliSizeOverPDU;
  std::vector<s7comm::Value> values;
  if (const int error = readItems(connection, items, values)) return error;
  for (std::size_t i = 0; i < list.size(); ++i)
    list[i].Result = copy(values[i], bytesOf(list[i]), static_cast<std::uint8_t*>(list[i].pdata));
  return 0;
}

int writeMany(Connection& connection, std::span<TS7DataItem> list) {
  std::vector<AnyItem> items;
  std::size_t bytes = 0;
  if (const int error = itemsOf(list, items, bytes)) return error;
  if (kJobHead + kItemAddress * items.size() + bytes > connection.pdu()) return errCliSizeOverPDU;
  std::vector<s7comm::Bytes> values;
  for (const TS7DataItem& item : list) {
    const auto* const data = static_cast<const std::uint8_t*>(item.pdata);
    values.emplace_back(data, data + bytesOf(item));
  }
  std::vector<ItemCode> codes;
  if (const int error = writeItems(connection, items, values, codes)) return error;
  for (std::size_t i = 0; i < list.size(); ++i) list[i].Result = errorOf(codes[i]);
  return 0;
}

}  // namespace merker::s7client
