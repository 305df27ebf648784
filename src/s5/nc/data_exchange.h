// FB 61 NCD-LESE and FB 62 NCD-SCHR: the FIFO of jobs and the hand-shake in DB 36 (S5-FM-23 … -47).
#pragma once

#include <array>
#include <deque>
#include <optional>

#include "nc/interface_byte.h"
#include "nc/job.h"

namespace merker::nc {

struct ExchangeOptions {
  bool enabled = true;    // the option bit; else error 8
  unsigned capacity = 8;  // jobs that wait, without the one that runs
  // A job begins at the next multiple of this and takes as long: the interpolation clock.
  Duration clock = Duration::milliseconds(20);
  HandshakeBits bits{};
  Model model = Model::Grinding;
};

class DataExchange {
 public:
  explicit DataExchange(const ExchangeOptions& options) : options_(options) {}

  // The trap if the parameters are wrong.
  std::optional<sinumerik::Trap> call(bool write, sinumerik::Machine& machine,
                                      std::span<const std::uint16_t> parameters);
  void restart(sinumerik::Machine& machine);
  void clear();
  void cycleBegins() { ++cycle_; }
  std::optional<sinumerik::Trap> advance(sinumerik::Machine& machine, Control& control,
                                         Instant now);
  Instant next() const;
  void delay(Duration by);  // all jobs stood still for so long

 private:
  struct Waiting {
    Job job;
    Instant earliest;
  };
  // What is known of the calls with an interface byte.
  struct Caller {
    std::optional<Request> last;  // with the signal 1, none since then with 0
    std::uint64_t cycle = 0;      // of that call
    bool waits = false;           // for room in the FIFO
  };

  Error request(sinumerik::Machine& machine, const Request& asked);
  Error take(sinumerik::Machine& machine, const Request& asked, Caller& caller);
  void enqueue(const Job& job, Instant now);
  void release(sinumerik::Machine& machine, unsigned number);
  void begin(sinumerik::Machine& machine);
  std::optional<sinumerik::Trap> finish(sinumerik::Machine& machine, Control& control);
  bool full() const { return jobs_.size() >= options_.capacity; }

  ExchangeOptions options_;
  std::deque<Waiting> jobs_;
  std::optional<Job> running_;
  Instant end_;  // of the running job
  std::uint64_t cycle_ = 0;
  std::array<Caller, kInterfaceBytes + 1> callers_{};  // by number
};

}  // namespace merker::nc
