// A day of an operator panel in virtual time: 207 values a second are read and some written over S7
// communication from a CPU that runs its program. Prints the memory in use as it goes; the exit
// code is 1 if the last hour has more than the second.
#include <malloc.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include "compilation/build.h"
#include "s7comm/request.h"
#include "s7comm/session.h"
#include "served/exchange.h"

namespace {

using namespace merker;
using s7comm::AnyItem;
using s7comm::Bytes;

constexpr int kValuesASecond = 207;
constexpr int kValuesARequest = 19;            // as many as a PDU of 240 octets holds
constexpr std::size_t kTolerated = 64 * 1024;  // bytes: what the allocator keeps in another order

const char* const kProgram =
    "DATA_BLOCK DB 1\nSTRUCT\n a : ARRAY [0..63] OF INT;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n"
    "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n L MW 20;\n + 1;\n T MW 20;\n T DB1.DBW 2;\n"
    " U E 0.0;\n = A 0.0;\nEND_ORGANIZATION_BLOCK\n";

// A panel and a CPU, with PDUs in between that go by no network.
struct Day {
  compilation::Build build =
      compilation::build(project::load("a.awl", {}, {{"a.awl", kProgram}}), false);
  std::unique_ptr<controller::Controller> plc = build.controller();
  std::unique_ptr<monitor::Monitor> monitor =
      monitor::monitorOf(*plc, build.project.symbols, build.resolver());
  served::Exchange exchange;
  std::shared_ptr<s7comm::Session> session =
      std::make_shared<s7comm::Session>(exchange, [this](const Bytes& answer) { answers(answer); });
  std::uint16_t reference = 0;
  std::uint64_t values = 0, writes = 0;

  Day() {
    plc->onCycle([this](controller::Controller&) { exchange.cycleEnded(*monitor); });
    plc->memoryReset();
    plc->start();
    exchange.opened();
    session->receive(s7comm::setupRequest(++reference, {}));
    plc->advanceCycles(2);  // from here on there are values of a cycle's end
  }
  ~Day() { exchange.closed(); }
  Day(const Day&) = delete;

  void answers(const Bytes& octets) {
    const auto pdu = s7comm::readPdu(octets);
    if (const auto read = s7comm::readAnswer(*pdu)) values += read->size();
    if (const auto written = s7comm::writeAnswer(*pdu)) writes += written->size();
  }

  void ask(int count) {
    std::vector<AnyItem> items;
    for (int i = 0; i < count; ++i)
      items.push_back({.type = s7comm::ElementType::Int,
                       .block = 1,
                       .memory = s7comm::Memory::DataBlock,
                       .address = static_cast<std::uint32_t>(i) * 16});
    session->receive(s7comm::readRequest(++reference, items));
  }

  void second() {
    for (int left = kValuesASecond; left > 0; left -= kValuesARequest)
      ask(std::min(left, kValuesARequest));
    const AnyItem item{.type = s7comm::ElementType::Int,
                       .block = 1,
                       .memory = s7comm::Memory::DataBlock,
                       .address = 320};
    const Bytes value = {0, static_cast<std::uint8_t>(reference)};
    session->receive(s7comm::writeRequest(++reference, {&item, 1}, {&value, 1}));
    plc->advanceTo(plc->now() + Duration::seconds(1));
  }
};

std::size_t used() { return mallinfo2().uordblks; }

}  // namespace

int main(int count, char** arguments) {
  const int hours = count > 1 ? std::atoi(arguments[1]) : 24;
  Day day;
  std::size_t second = 0, last = 0;
  for (int hour = 1; hour <= hours; ++hour) {
    for (int i = 0; i < 3600; ++i) day.second();
    last = used();
    if (hour == 2) second = last;
    std::printf("hour %2d: %llu values read, %llu written, %zu bytes in use\n", hour,
                static_cast<unsigned long long>(day.values),
                static_cast<unsigned long long>(day.writes), last);
    std::fflush(stdout);
  }
  const bool whole = day.values == static_cast<std::uint64_t>(hours) * 3600 * kValuesASecond;
  std::printf("%s\n", !whole                       ? "values are missing"
                      : last > second + kTolerated ? "it grows"
                                                   : "flat");
  return whole && last <= second + kTolerated ? 0 : 1;
}
