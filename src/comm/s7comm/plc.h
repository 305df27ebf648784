// What a server of S7 communication asks of a PLC. All calls come from the thread of the
// connections and return at once; `done` is called in the same thread, within the call or later.
#pragma once

#include <array>
#include <functional>
#include <memory>
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

class Outlet;

// Values that the PLC sends by itself, at the interval in its own time.
struct CyclicRead {
  std::uint8_t subfunction = 0;  // of its indications
  bool onChange = false;         // only when a value is another than the one sent last
  std::uint32_t milliseconds = 0;
  std::vector<Range> ranges{};
  // What an indication says of them; called in the thread of the PLC.
  std::function<Bytes(const std::vector<Value>&)> data{};
};

class CyclicReads {
 public:
  virtual ~CyclicReads() = default;
  // The number of the job, and the values as they are now.
  using SubscribeDone = std::function<void(Error, std::uint8_t job, const std::vector<Value>&)>;
  using Done = std::function<void(Error)>;
  // Nothing for `job`: a new one; else this one has these values from now on.
  virtual void subscribe(const std::shared_ptr<Outlet>& client, std::optional<std::uint8_t> job,
                         CyclicRead read, SubscribeDone done) = 0;
  virtual void unsubscribe(const std::shared_ptr<Outlet>& client, std::uint8_t job, Done done) = 0;
};

// What a client wants to be told of, as bits of its request.
enum MessageKind : std::uint8_t {
  kModes = 0x01,
  kSystemEvents = 0x02,
  kUserEvents = 0x04,
  kAlarms = 0x80
};

// A block-related message (ALARM_S, ALARM_SQ), or its state.
struct AlarmState {
  std::uint32_t number = 0;
  bool waits = false;  // for an acknowledgement: ALARM_SQ
  bool signal = false, acknowledged = false;
  ClockTime coming{}, going{};  // 0: not yet
  Bytes comingValue{}, goingValue{};
};

class Messages {
 public:
  virtual ~Messages() = default;
  using Done = std::function<void(Error)>;
  using CodesDone = std::function<void(const std::vector<ItemCode>&)>;
  using AlarmsDone = std::function<void(const std::optional<std::vector<AlarmState>>&)>;
  // From now on these kinds and no others (messages.h has what is sent); 0: none.
  virtual void listen(const std::shared_ptr<Outlet>& client, std::uint8_t kinds, Done done) = 0;
  // A code for each.
  virtual void acknowledge(std::vector<std::uint32_t> numbers, CodesDone done) = 0;
  virtual void lock(std::vector<std::uint32_t> numbers, bool locked, CodesDone done) = 0;
  // Nothing: the machine has no messages.
  virtual void alarms(AlarmsDone done) = 0;
};

class Plc : public BlockStore, public CyclicReads, public Messages {
 public:
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
  using Done = CyclicReads::Done;
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
