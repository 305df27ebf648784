// The sub-module 2.4 "Count" of a compact CPU: its channels between the terminals of the digital
// sub-module 2.2 and the CPU.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "catalogue/counting.h"
#include "io/rack.h"
#include "technology/channel.h"
#include "technology/job.h"

namespace merker::technology {

class Counting {
 public:
  // The rack must outlive it. Without a sub-module 2.4 it has no channels.
  explicit Counting(io::Rack& rack);

  void start(Instant now);  // the CPU starts: all as parametrised (CNT-GATE-10)
  void stop();              // the CPU stops (CNT-GATE-11)
  Instant next() const;
  // The same with levels that a call can see (STS_STRT).
  Instant nextVisible() const;
  // Takes what happened at the terminals, and brings channels, outputs and input bytes to `now`.
  void advance(Instant now);
  // OB 40 for this module has ended, or was never called (CNT-PRAL-12, CNT-DIAG-07).
  void acknowledged(std::uint32_t address);

  // For the system functions: a channel at `now`, null if it does not exist; whether the sub-module
  // has this address. `changed`: outputs and interrupts follow at the next instruction.
  bool answers(std::uint32_t address) const;
  bool inUse() const;   // a channel has a function
  bool steady() const;  // each function is: `nextVisible` tells all that it does by itself
  bool sound() const;   // no parametrising error
  std::uint32_t channels() const { return static_cast<std::uint32_t>(channels_.size()); }
  Channel& at(std::uint32_t channel, Instant now);
  void changed() { changed_ = true; }

  // What a block remembers between two calls of a channel.
  struct Job {
    EdgeMemory request;
    bool done = true;
    std::uint16_t status = 0;
    bool error = false;
  };
  Job& job(std::uint32_t channel) { return jobs_[channel]; }

 private:
  void connect(std::uint32_t channel, const CountingPins& pins);
  void takeEdges();
  void advanceChannels(Instant now);
  void collect();
  void show();
  void raise(std::uint32_t points);
  void tell(std::uint32_t points);
  void setLost(bool lost);

  io::Rack& rack_;
  std::uint32_t module_ = 0, digital_ = 0;  // in the rack
  const io::Module* self_ = nullptr;        // null: there is no such sub-module
  std::vector<Channel> channels_;
  std::array<Job, 4> jobs_;
  struct Wire {
    std::uint32_t channel = 0;
    Channel::Name input = Channel::TrackA;
  };
  std::array<std::optional<Wire>, 32> wires_;  // by digital input
  std::array<io::Terminal, 4> outputs_;
  bool changed_ = false;
  std::uint32_t inService_ = 0, waiting_ = 0;  // causes of hardware interrupts
};

}  // namespace merker::technology
