// The sub-module PtP in operation: the interface, the blocks that work with it, its line and the
// partner at the other end. It moves when somebody looks: an idle or unobserved line costs nothing.
#pragma once

#include <deque>
#include <memory>

#include "serial/line.h"
#include "serial/link_blocks.h"
#include "serial/partner.h"

namespace merker::serial {

class Coupling {
 public:
  static constexpr std::size_t kMostSightings = 65'536;

  explicit Coupling(const Parameters& parameters);

  const Parameters& parameters() const { return parameters_; }
  Interface& interface() { return operation_->interface; }
  struct Blocks {
    explicit Blocks(Interface& interface);
    void start();
    SendBlock send;
    ReceiveBlock receive;
    ClearBlock clear;
    LinkJobBlock sendLink, fetchLink;
    ServeBlock serve;
    std::uint32_t syncBlock = 0;  // the first SYNC_DB since the start; 0: none yet
  };
  Blocks& blocks() { return operation_->blocks; }
  Partner& partner() { return partner_; }

  // When the CPU has to be told something: only with the diagnostic interrupt.
  Instant next() const;
  void advance(Instant now);
  void cpuStarted(Instant now);
  void cpuStopped(Instant now);
  void supply(bool on, Instant now);
  std::optional<bool> takeWireBreak() { return operation_->interface.takeWireBreak(); }

  // For scenarios and the outside. All that a partner is given: `advance` first, then this.
  const Settings& partnerSettings() const { return partnerSettings_; }
  void setPartner(const Settings& settings, Instant now);
  enum class End : std::uint8_t { Cpu, Partner };
  // The pair that this end listens to.
  void cut(End end, bool open, Instant now);
  void swapPolarity(End end, bool swapped, Instant now);
  void noise(End end, std::uint16_t bits, Instant now);
  // The character that this end sends after so many others (0: the next one).
  void disturb(End end, std::uint64_t after, const Fault& fault);

  // The last characters on the line, the oldest first; numbered from the beginning.
  const std::deque<Sighting>& sightings() const { return sightings_; }
  std::uint64_t seen() const { return seen_; }
  bool powered() const { return powered_; }

 private:
  struct Operation {
    explicit Operation(const Parameters& parameters) : interface(parameters), blocks(interface) {}
    Interface interface;
    Blocks blocks;
  };
  // The interface without supply.
  struct Silence : Driver {
    void start(Instant) override {}
    void received(const Character&) override {}
    void interrupted(Instant) override {}
    void restored(Instant) override {}
    std::optional<std::uint8_t> next(Instant) override { return std::nullopt; }
    void sent(Instant) override {}
    Instant due() const override { return Instant::never(); }
    void expire(Instant) override {}
  };
  static std::size_t portOf(End end) { return static_cast<std::size_t>(end); }
  void connect(Instant now);
  void see(const Sighting& sighting);

  Parameters parameters_;
  Settings partnerSettings_;
  std::unique_ptr<Operation> operation_;
  Silence silence_;
  Partner partner_;
  std::unique_ptr<Line> line_;
  bool powered_ = true;
  struct Wiring {
    bool cut = false, swapped = false;
  };
  std::array<Wiring, 2> wiring_;
  std::deque<Sighting> sightings_;
  std::uint64_t seen_ = 0;
};

}  // namespace merker::serial
