// Jobs of test and installation (userdata group 1): what a programming device looks at, modifies
// and forces. On the wire a job is a head of parameters (words: 0, how, how often, length of the
// answer, five ones, trigger event, then what the event needs) and data; both have their length
// before them. Structure: Wireshark's dissector of S7comm; lengths: clients for block status and
// variable tables.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "s7comm/outlet.h"
#include "s7comm/range.h"

namespace merker::s7comm {

// The subfunctions of group 1.
enum class TestFunction : std::uint8_t {
  BlockStatus = 0x01,
  VariableStatus = 0x02,
  InterruptStack = 0x03,
  BlockStack = 0x04,
  LocalStack = 0x05,
  Modify = 0x08,
  Force = 0x09,
  Breakpoint = 0x0A,
  ExitHold = 0x0B,
  Disable = 0x0D,
  Enable = 0x0E,
  Delete = 0x0F,
  List = 0x10,
  Read = 0x11,
  Replace = 0x12,
  ProgramStatus = 0x13,
  FlashLed = 0x16
};

enum class TriggerEvent : std::uint16_t {
  Now = 0x0000,
  System = 0x0100,
  CycleBegin = 0x0200,
  CycleEnd = 0x0300,
  Stop = 0x0400,            // the transition to it
  Addresses = 0x0600,       // of the code of a block
  CalledAddresses = 0x0601  // where the block was called as the parameters say
};

// One operand, or a row of them; with a value when it is to be modified or forced.
struct TestItem {
  ItemCode code = ItemCode::Done;  // else there is no such operand
  Range range{};
  Bytes value{};
};

// A job as its number names it: the CPU gives one to each request.
struct TestName {
  std::uint8_t function = 0, number = 0;
  bool operator==(const TestName&) const = default;
};

// The registers that a line shows, as a mask; in this order they are told.
enum TestRegister : std::uint8_t {
  kStatusWord = 0x01,
  kAccu1 = 0x02,
  kAccu2 = 0x04,
  kAr1 = 0x08,
  kAr2 = 0x10,
  kDb = 0x20,
  kDi = 0x40
};

struct TestRegisters {
  std::uint16_t status = 0;
  std::uint32_t accu1 = 0, accu2 = 0, ar1 = 0, ar2 = 0;
  std::uint16_t db = 0, di = 0;  // that are open; 0: none
};

// Code of a block whose execution is watched: the registers behind each of these instructions.
struct BlockWatch {
  struct Line {
    std::uint16_t address = 0;
    std::uint8_t registers = 0;
  };
  std::uint16_t type = 0, number = 0;  // OB 08, DB 0A, FC 0C, FB 0E, as in a container
  std::uint16_t begin = 0;
  std::uint8_t registers = 0;  // before the first instruction
  std::vector<Line> lines{};
  // Only calls by this block, or with these open.
  struct Block {
    std::uint16_t type = 0, number = 0;
  };
  std::optional<Block> caller{};
  std::optional<std::uint16_t> db{}, di{};
};

struct TestJob {
  TestName name{};
  std::uint16_t how = 0;    // 0 at once, 1 when it is enabled, 2 time and again
  std::uint16_t often = 0;  // 0 in each cycle, 1 once, 2 always
  std::uint16_t event = 0;  // TriggerEvent
  std::vector<TestItem> items{};
  BlockWatch block{};
  Bytes parameters{}, data{};  // as they came: a job can be read
};

struct TestRequest {
  TestFunction function = TestFunction::List;
  TestJob job{};     // of a replacement: the new one
  TestName other{};  // whom a request for jobs is about
  std::string password{};
};

struct TestAnswer {
  Error error = Error::None;
  std::uint8_t number = 0;  // of the request
  Bytes data{};
};

// None: the request is as it should be, and read; its function is given.
Error readTest(View octets, TestRequest& request);

// The octets of an answer or an indication with these data.
Bytes testOctets(View data);
Bytes statusData(const std::vector<Value>& values);
Bytes modifiedData(const std::vector<ItemCode>& codes);
// Types and numbers of the open data blocks: 6 octets.
void appendOpenBlocks(Bytes& data, std::uint16_t db, std::uint16_t di);
std::size_t registerOctets(std::uint8_t registers);
void appendRegisters(Bytes& data, const TestRegisters& values, std::uint8_t registers);
Bytes jobData(const TestJob& job);  // all that it said
// What a job says that forces these, for who reads it.
TestJob forceJob(std::uint8_t number, std::vector<TestItem> items);

}  // namespace merker::s7comm
