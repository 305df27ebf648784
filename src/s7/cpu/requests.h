// Requests of OBs: which events wait, which are lost, and what an OB that is not loaded means
// (S7-ERR-01, -05; S7-OBI-07, -10). The class of a waiting request begins when nothing of the same
// or a higher class runs.
#pragma once

#include <string_view>
#include <vector>

#include "cpu/interrupts.h"
#include "cpu/present_faults.h"
#include "cpu/state_control.h"

namespace merker::cpu {

struct Request {
  std::uint8_t ob = 0;
  std::uint8_t priority = 0;
  StartInformation start{};
};

class Requests {
 public:
  // `interrupts`: which OBs are locked.
  Requests(Machine& machine, EventLog& log, StateControl& state, const Interrupts& interrupts,
           PresentFaults& faults)
      : machine_(machine), log_(log), state_(state), interrupts_(interrupts), faults_(faults) {}
  // In the order of their events.
  const std::vector<Request>& waiting() const { return waiting_; }

  // The OB of a time event, one at a time.
  void request(const StartInformation& start);
  // Behind those that wait already.
  void queue(StartInformation start);
  // An asynchronous error (OB 80 to 87): entered, then its OB is asked for or the CPU stops
  // (S7-ERR-01). `start` as its OB will see it.
  void asynchronousError(const StartInformation& start, std::string_view detail = {});
  // OB 80. `cause` is the start information of the OB that could not begin, or of the one that took
  // too long.
  void timeError(std::uint8_t faultId, std::uint32_t info, const StartInformation& cause);
  // OB 85 instead of the OB that was asked for.
  void obMissing(const StartInformation& wanted);

  // The waiting request of the highest class, the oldest among equals, if it is higher than what
  // runs.
  void startHighest();
  void clear() { waiting_.clear(); }
  void clearErrors();  // OB 80 to 87

 private:
  bool runsOrWaits(std::uint8_t ob) const;

  Machine& machine_;
  EventLog& log_;
  StateControl& state_;
  const Interrupts& interrupts_;
  PresentFaults& faults_;
  std::vector<Request> waiting_;
};

}  // namespace merker::cpu
