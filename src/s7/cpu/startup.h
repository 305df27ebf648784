// Warm, hot and cold restart: OB, event and start information of each (S7-OBI-12, S7-DIAG-02).
#pragma once

#include <cstddef>

#include "cpu/event.h"
#include "cpu/operating_state.h"
#include "cpu/start_information.h"

namespace merker::cpu {

class Startup {
 public:
  struct Situation {
    std::uint16_t stopEvent = 0;  // of the last STOP
    bool buffered = true;         // no data was lost when the power was off
    bool hotRestart = false;      // the model has it
    DateAndTime time{};
  };
  // `interrupted`: levels of the program that a hot restart goes on with.
  void begin(Restart how, const Situation& situation, std::size_t interrupted);

  Restart how() const { return how_; }
  std::uint8_t ob() const;
  Event event() const;
  // Of the last startup, with or without its OB (SFC 6).
  const StartInformation& information() const { return information_; }
  std::size_t interrupted() const { return interrupted_; }

 private:
  Restart how_ = Restart::ManualWarm;
  StartInformation information_{};
  std::size_t interrupted_ = 0;
};

}  // namespace merker::cpu
