#include "s7comm/test_job.h"

#include <algorithm>
#include <iterator>

#include "base/bytes.h"
#include "s7comm/block_watch.h"
#include "s7comm/data_item.h"

namespace merker::s7comm {
namespace {

constexpr std::size_t kJobWords = 20;  // octets of the parameters that every job has
constexpr std::size_t kItemAddress = 6;

// Takes `count` octets off `bytes`; nothing: there are fewer.
std::optional<View> taken(View& bytes, std::size_t count) {
  if (bytes.size() < count) return std::nullopt;
  const View first = bytes.first(count);
  bytes = bytes.subspan(count);
  return first;
}

Bytes copied(View octets) { return {octets.begin(), octets.end()}; }

struct TestArea {
  std::uint8_t code;  // the high nibble
  Memory memory;
};
constexpr TestArea kTestAreas[] = {{0x0, Memory::Flag},     {0x1, Memory::Input},
                                   {0x2, Memory::Output},   {0x3, Memory::Peripheral},
                                   {0x5, Memory::Timer},    {0x6, Memory::Counter},
                                   {0x7, Memory::DataBlock}};

// Octets by the low nibble: bit, byte, word, double word, timer or counter.
constexpr std::uint8_t kTestWidths[] = {1, 1, 2, 4, 2};

// Area and width, bit or how many, data block (2), byte or number (2).
TestItem testItem(View address) {
  const std::uint8_t area = address[0] >> 4, width = address[0] & 0x0F;
  const auto* const found = std::ranges::find(kTestAreas, area, &TestArea::code);
  if (found == std::end(kTestAreas) || width >= std::size(kTestWidths))
    return {.code = ItemCode::TypeNotSupported};
  const bool cell = isCell(found->memory), bit = width == 0 && !cell;
  if (bit && address[1] > 7) return {.code = ItemCode::OutOfRange};
  const std::uint32_t each = cell ? 2u : kTestWidths[width], count = bit ? 1u : address[1];
  return {.range = {.memory = found->memory,
                    .block = found->memory == Memory::DataBlock ? loadWord(&address[2])
                                                                : std::uint16_t{0},
                    .begin = loadWord(&address[4]),
                    .octets = each * std::max(count, 1u),
                    .bit = bit ? address[1] : std::uint8_t{0},
                    .oneBit = bit}};
}

// How many, their addresses, and their values if they are to be modified.
Error readTestItems(View data, bool values, std::vector<TestItem>& items) {
  const auto count = taken(data, 2);
  if (!count) return Error::WrongJobLength;
  for (std::size_t i = loadWord(count->data()); i > 0; --i) {
    const auto address = taken(data, kItemAddress);
    if (!address) return Error::WrongJobLength;
    items.push_back(testItem(*address));
  }
  for (TestItem& item : items) {
    if (!values) break;
    const auto value = readDataItem(data);
    if (!value) return Error::WrongJobLength;
    item.value = copied(value->octets);
    if (item.code == ItemCode::Done && item.value.size() != item.range.octets)
      return Error::WrongTestValue;
  }
  return items.empty() ? Error::WrongTestData : Error::None;
}

// What is done at once needs no trigger.
constexpr TestFunction kAtOnce[] = {TestFunction::InterruptStack, TestFunction::BlockStack,
                                    TestFunction::LocalStack, TestFunction::ExitHold,
                                    TestFunction::FlashLed};

bool isAtOnce(TestFunction function) {
  return std::ranges::find(kAtOnce, function) != std::end(kAtOnce);
}

Error readJob(TestFunction function, View given, View data, TestJob& job) {
  if (given.size() < kJobWords && !isAtOnce(function)) return Error::WrongJobLength;
  Bytes whole = copied(given);
  whole.resize(std::max(whole.size(), kJobWords));
  const View parameters = whole;
  job.name.function = static_cast<std::uint8_t>(function);
  job.how = loadWord(&parameters[2]);
  job.often = loadWord(&parameters[4]);
  job.event = loadWord(&parameters[18]);
  job.parameters = copied(parameters);
  job.data = copied(data);
  switch (function) {
    case TestFunction::VariableStatus:
      return readTestItems(data, false, job.items);
    case TestFunction::Modify:
    case TestFunction::Force:
      return readTestItems(data, true, job.items);
    case TestFunction::BlockStatus:
    case TestFunction::ProgramStatus:
      return readBlockWatch(function, parameters, data, job.block);
    case TestFunction::Breakpoint:
      return readBreakpoint(parameters, job.block);
    default:
      return Error::None;
  }
}

// Function and number behind `skipped` octets.
Error readName(View& data, std::size_t skipped, TestName& name) {
  if (!taken(data, skipped)) return Error::WrongJobLength;
  const auto two = taken(data, 2);
  if (!two) return Error::WrongJobLength;
  name = {(*two)[0], (*two)[1]};
  return Error::None;
}

// The length of the parameters, that of the data, both.
struct TestParts {
  View parameters, data;
};
std::optional<TestParts> partsOf(View octets) {
  const auto lengths = taken(octets, 4);
  if (!lengths) return std::nullopt;
  const auto parameters = taken(octets, loadWord(lengths->data()));
  const auto data = taken(octets, loadWord(lengths->data() + 2));
  if (!parameters || !data) return std::nullopt;
  return TestParts{*parameters, *data};
}

void appendParts(Bytes& octets, View parameters, View data) {
  appendWord(octets, static_cast<std::uint32_t>(parameters.size()));
  appendWord(octets, static_cast<std::uint32_t>(data.size()));
  octets.insert(octets.end(), parameters.begin(), parameters.end());
  octets.insert(octets.end(), data.begin(), data.end());
}

std::uint8_t areaCode(const Range& range) {
  const auto* const area = std::ranges::find(kTestAreas, range.memory, &TestArea::memory);
  const std::uint8_t width = range.oneBit            ? 0
                             : isCell(range.memory)  ? 4
                             : range.octets == 2     ? 2
                             : range.octets % 4 == 0 ? 3
                                                     : 1;
  return static_cast<std::uint8_t>(area->code << 4 | width);
}

void appendAddress(Bytes& octets, const Range& range) {
  const std::uint8_t code = areaCode(range);
  const std::uint32_t count = range.oneBit ? range.bit : range.octets / kTestWidths[code & 0x0F];
  octets.insert(octets.end(), {code, static_cast<std::uint8_t>(count)});
  appendWord(octets, range.block);
  appendWord(octets, range.begin);
}

// The last one is filled up, too.
void appendValue(Bytes& octets, ItemCode code, View value) {
  writeDataItem(octets, {code, value.empty() ? DataUnit::None : DataUnit::Octets, value});
  if (octets.size() % 2 != 0) octets.push_back(0);
}

}  // namespace

Error readTest(View octets, TestRequest& request) {
  const auto parts = partsOf(octets);
  if (!parts) return Error::WrongJobLength;
  View data = parts->data;
  switch (request.function) {
    case TestFunction::Enable:
    case TestFunction::Disable:
    case TestFunction::Read:
      return readName(data, 0, request.other);
    case TestFunction::Delete:
      return readName(data, 2, request.other);
    case TestFunction::Replace: {
      if (const Error error = readName(data, 2, request.other); error != Error::None) return error;
      const auto job = partsOf(data);
      if (!job) return Error::WrongJobLength;
      return readJob(static_cast<TestFunction>(request.other.function), job->parameters, job->data,
                     request.job);
    }
    case TestFunction::List:
      return Error::None;
    default:
      return readJob(request.function, parts->parameters, parts->data, request.job);
  }
}

// As S7-300 answer: what the two words of parameters mean nobody knows.
Bytes testOctets(View data) {
  constexpr std::uint8_t kAnswerWords[] = {1, 0, 0, 1};
  Bytes octets;
  appendParts(octets, kAnswerWords, data);
  return octets;
}

Bytes statusData(const std::vector<Value>& values) {
  Bytes data;
  appendWord(data, static_cast<std::uint32_t>(values.size()));
  for (const Value& value : values) appendValue(data, value.code, value.octets);
  return data;
}

Bytes modifiedData(const std::vector<ItemCode>& codes) {
  Bytes data;
  appendWord(data, static_cast<std::uint32_t>(codes.size()));
  for (const ItemCode code : codes) data.push_back(static_cast<std::uint8_t>(code));
  if (data.size() % 2 != 0) data.push_back(0);
  return data;
}

Bytes jobData(const TestJob& job) {
  Bytes data;
  appendParts(data, job.parameters, job.data);
  return data;
}

TestJob forceJob(std::uint8_t number, std::vector<TestItem> items) {
  constexpr std::uint16_t kForceHow = 0x0100, kAlways = 2;
  TestJob job{.name = {static_cast<std::uint8_t>(TestFunction::Force), number},
              .how = kForceHow,
              .often = kAlways,
              .items = std::move(items)};
  for (const std::uint16_t word : {std::uint16_t{0}, kForceHow, kAlways, std::uint16_t{4}})
    appendWord(job.parameters, word);
  for (int i = 0; i < 5; ++i) appendWord(job.parameters, 1);
  appendWord(job.parameters, 0);
  appendWord(job.data, static_cast<std::uint32_t>(job.items.size()));
  for (const TestItem& item : job.items) appendAddress(job.data, item.range);
  for (const TestItem& item : job.items) appendValue(job.data, ItemCode::Requested, item.value);
  return job;
}

}  // namespace merker::s7comm
