// The communication blocks of RK 512: SFB 63 SEND_RK, SFB 64 FETCH_RK and SFB 65 SERVE_RK, call by
// call, without an instance data block (technology manual 6.5.2; PTP-SFB63 to -SFB65).
#pragma once

#include "serial/blocks.h"

namespace merker::serial {

// Parameters of a job as the program gives them.
struct LinkRequest {
  std::int32_t cpu = 1;  // R_CPU
  char type = 'D';       // R_TYPE
  std::int32_t block = 0, offset = 0;
  std::int32_t flagByte = 255, flagBit = 0;
  std::int32_t length = 1;
};
// The job, or what is wrong with the parameters.
struct LinkRequestResult {
  Event event = Event::None;
  LinkJob job;
};
LinkRequestResult jobOf(const LinkRequest& request, bool fetch);

// SEND_RK and FETCH_RK: one job of both at a time (PTP-RK512-31).
class LinkJobBlock {
 public:
  LinkJobBlock(Interface& interface, bool fetch) : interface_(interface), fetch_(fetch) {}
  void start() { state_.start(); }
  bool running() const { return running_; }
  Answer call(const Control& control, const LinkRequest& request, const Place& data,
              DataBlocks& blocks, Instant now);

 private:
  void accept(const Control& control, const LinkRequest& request, const Place& data,
              const DataBlocks& blocks, Instant now);
  void transfer(DataBlocks& blocks, Instant now);
  void finish();
  void reset();
  void fail(Event event);

  Interface& interface_;
  bool fetch_;
  CallState state_;
  bool running_ = false;
  Place data_;
  std::size_t done_ = 0;
};

class ServeBlock {
 public:
  explicit ServeBlock(Interface& interface) : interface_(interface) {}
  void start() { state_.start(); }
  struct Served {
    Answer answer;
    std::optional<LinkJob> job;  // with NDR
  };
  // REQ of the control is EN_R.
  Served call(const Control& control, LinkMemory& memory, Instant now);

 private:
  void work(const Control& control, LinkMemory& memory, Instant now);
  void reset();
  void report(unsigned calls);

  Interface& interface_;
  CallState state_;
  std::optional<LinkJob> job_;  // to be reported
};

}  // namespace merker::serial
