// FB 190 K-LEITPC: the area of 128 words through which two PLCs exchange data, and the macro that
// copies between it and a data block (S5-FM-50 … -54).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "nc/macro_error.h"

namespace merker::nc {

constexpr unsigned kCouplingWords = 128;  // 0 and 127 are not the user's

enum class Partner : std::uint8_t { NotStarted, Runs, Failed };

// The dual-port memory. Two PLCs share one; whoever owns both moves them through time in turn.
struct CouplingArea {
  std::array<std::uint16_t, kCouplingWords> words{};
  bool faulty = false;  // message 1
  bool silent = false;  // the memory does not answer: 6151
  Partner master = Partner::NotStarted;
};

enum class Side : std::uint8_t { Control, Master };

class Coupling {
 public:
  // `meet` brings the other PLC to the present moment; it is called before each look at the area.
  void connect(std::shared_ptr<CouplingArea> area, Side side, std::function<void()> meet = {});

  // ADPR, DBDW, R/A, MELD. Its messages go to MELD; only a MELD that is no byte stops the PLC.
  std::optional<sinumerik::Trap> transfer(sinumerik::Machine& machine,
                                          std::span<const std::uint16_t> parameters);
  void started();
  void stopped();
  bool masterRuns() const;  // false: it has run and has failed

 private:
  std::uint8_t copy(sinumerik::Machine& machine, std::uint16_t place, std::uint16_t order);
  void show(Partner state);
  void meet() const {
    if (meet_) meet_();
  }

  std::shared_ptr<CouplingArea> area_;
  Side side_ = Side::Control;
  std::function<void()> meet_;
};

}  // namespace merker::nc
