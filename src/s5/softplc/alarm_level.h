// The alarm level OB 2: the edges that request it, its begin and its end (S5-OB-06 … -14).
#pragma once

#include <optional>

#include "softplc/alarm_input.h"
#include "softplc/processor.h"
#include "softplc/run_times.h"
#include "softplc/transfer_flags.h"

namespace merker::sinumerik {

constexpr std::uint8_t kAlarmOb = 2;

class AlarmLevel {
 public:
  AlarmLevel(Processor& processor, TransferFlags& flags, RunTimes& times,
             const Surroundings& around);

  void forgetRequests() { waiting_ = {}; }
  // The program begins: edges of this input byte count from its present value on.
  void watch(unsigned byte);
  void terminalChanged(unsigned byte, std::uint8_t value);

  bool runs() const {
    const auto& levels = processor_.machine().levels;
    return !levels.empty() && levels.back().ob == kAlarmOb;
  }
  // No edge comes or waits.
  bool quiet() const { return input_.quiet() && !waiting_.any(); }
  // The sampling of this instant. A request while OB 2 still runs is a processing delay; as a
  // message it waits for its end (S5-OB-12).
  std::optional<Trap> sample(Instant at);
  // OB 2 has ended; then it begins again if a request waits.
  void end();
  std::optional<Trap> beginWaiting();

  // Whether its run times exceed the limit (S5-SCHED-10), for the first time since they did not.
  bool exceeds(Duration limit);
  void sampled(Duration limit);

 private:
  std::optional<Trap> begin(Edges edges);

  Processor& processor_;
  TransferFlags& flags_;
  RunTimes& times_;
  const Surroundings& around_;
  AlarmInput input_;
  unsigned byte_ = 0;
  Edges waiting_;
  bool reported_ = false;  // that the limit is exceeded
};

}  // namespace merker::sinumerik
