// Block-related messages (SFC 17 to 19, 107, 108): what the CPU remembers of each message number,
// and what display devices have still to get. Source: System Software for S7-300/400, volume
// 2, 24.12 to 24.15.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <vector>

namespace merker::system {

// The value that a message carries.
struct AlarmValue {
  static constexpr std::size_t kMost = 12;  // bytes
  std::uint8_t type = 0;                    // code of an ANY
  std::vector<std::uint8_t> bytes;
};

// One transition of the signal, as it was when the function was called.
struct AlarmSignal {
  bool state = false;
  std::int64_t milliseconds = 0;  // since 1990-01-01, by the clock of the CPU
  AlarmValue value;
};

struct Alarm {
  std::uint32_t number = 0;     // EV_ID
  std::uint16_t function = 0;   // 17, 18, 107, 108
  std::uint32_t component = 0;  // CMP_ID of SFC 107 and 108
  AlarmSignal last;             // of the last call
  AlarmSignal coming;           // of the last one with 1
  bool acknowledged = false;    // the last coming message
  bool overflow = false;        // transitions were lost since the last message that was sent
  // SFC 17 and 107 wait for an acknowledgement, SFC 18 and 108 are always acknowledged.
  bool waitsForAcknowledgement() const { return function == 17 || function == 107; }
};

// What is sent to the devices that are logged on.
struct AlarmMessage {
  Alarm alarm;         // as it was then
  AlarmSignal signal;  // acknowledgement: the last one
  bool isAcknowledgement = false;
};

class Alarms {
 public:
  static constexpr std::size_t kMost = 40;  // messages at the same time: technical data, CPU 314C-2
  static constexpr std::size_t kUnsent = 2;  // transitions of a message that wait to be sent

  // RET_VAL of the call.
  enum class Result : std::uint16_t {
    Good = 0,
    BadNumber = 0x8081,
    NoMemory = 0x8082,
    Overflow = 0x8083,
    SameSignal = 0x8084,
    NobodyListens = 0x8085,
    FirstIsZero = 0x8087,
    OtherFunction = 0x8088
  };
  struct Report {
    std::uint32_t number = 0;
    std::uint16_t function = 0;
    std::uint32_t component = 0;
    AlarmSignal signal;
  };
  Result report(const Report& report);

  // Null if nothing is remembered of the number.
  const Alarm* find(std::uint32_t number) const;
  const std::map<std::uint32_t, Alarm>& list() const { return list_; }

  // Display devices that get messages.
  void logOn() { ++listeners_; }
  void logOff();
  // And stations that get the entries of the program in the diagnostic buffer (SFC 52).
  void eventsWanted(bool more) { more ? ++eventListeners_ : --eventListeners_; }
  bool areEventsHeard() const { return eventListeners_ > 0; }
  // False if there is no coming message to be acknowledged.
  bool acknowledge(std::uint32_t number);
  // Messages of this number are sent no more, or again. False: too many are locked.
  bool lock(std::uint32_t number, bool locked);
  // Takes what waits to be sent, the oldest first.
  std::vector<AlarmMessage> take();
  // A restart forgets everything but who is logged on.
  void clear();

 private:
  void forget(std::uint32_t number);
  std::size_t unsent(std::uint32_t number) const;

  std::map<std::uint32_t, Alarm> list_;
  std::set<std::uint32_t> locked_;
  std::deque<AlarmMessage> queue_;
  unsigned listeners_ = 0, eventListeners_ = 0;
};

}  // namespace merker::system
