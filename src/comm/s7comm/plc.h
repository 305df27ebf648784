// What a server of S7 communication asks of a PLC. All calls come from the thread of the
// connections and return at once; `done` is called in the same thread, within the call or later.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "s7comm/block_store.h"
#include "s7comm/range.h"
#include "s7comm/test_job.h"

namespace merker::s7comm {

struct Write {
  Range range;
  Bytes octets;
};

// Of the system status list (SZL): records of one length, one behind the other.
struct StatusList {
  Error error = Error::NoSuchList;  // None: the rest holds

  std::uint16_t recordLength = 0, records = 0;
  Bytes data{};
};

// BCD: year of two digits, month, day, hour, minute, second, milliseconds, day of the week.
using ClockTime = std::array<std::uint8_t, 8>;

enum class Control : std::uint8_t {
  WarmRestart,
  ColdRestart,
  Stop,
  CopyRamToRom,
  Compress,
  MemoryReset
};
enum class Controlled : std::uint8_t { Done, Already, Refused, Protected };

class Plc : public BlockStore {
 public:
  virtual ~Plc() = default;

  using ReadDone = std::function<void(std::vector<Value>)>;
  using WriteDone = std::function<void(std::vector<ItemCode>)>;
  // As they are at the end of a cycle, all of the same one.
  virtual void read(const std::vector<Range>& ranges, ReadDone done) = 0;
  // In this order, between two cycles.
  virtual void write(std::vector<Write> writes, WriteDone done) = 0;

  using StatusDone = std::function<void(const StatusList&)>;
  virtual void status(std::uint16_t list, std::uint16_t index, StatusDone done) = 0;
  using ClockDone = std::function<void(const std::optional<ClockTime>&)>;
  // Nothing: it has none.
  virtual void clock(ClockDone done) = 0;
  // What a protection may forbid comes with the password that the client has entered, or none.
  virtual void setClock(const ClockTime& time, const std::string& password, Done done) = 0;
  // Whether this is the password of the PLC.
  virtual void enter(const std::string& password, Done done) = 0;
  virtual void control(Control wish, const std::string& password,
                       std::function<void(Controlled)> done) = 0;
  using TestDone = std::function<void(const TestAnswer&)>;
  // A request of group 1; what a job says later goes to `client`, until that is closed.
  virtual void test(TestRequest request, std::shared_ptr<Outlet> client, TestDone done) = 0;

 protected:
  Plc() = default;
  Plc(const Plc&) = default;
  Plc& operator=(const Plc&) = default;
};

}  // namespace merker::s7comm
