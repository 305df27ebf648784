// The sub-module PtP in operation: the interface, the blocks that work with it, its line and the
// partner or the other station at the other end. It moves when somebody looks: an idle or
// unobserved line costs nothing.
#pragma once

#include <deque>
#include <functional>
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

  // From now on the interface of another station is at the other end, in place of the partner; both
  // begin anew. Whoever looks takes the other one along to its time before the line moves, so
  // everything happens in the order of time: `follow` moves the other station, `followed` this one.
  // `other` must live as long as this one moves.
  using Follow = std::function<void(Instant)>;
  void join(Coupling& other, Follow follow, Follow followed);
  bool joined() const { return other_ != nullptr; }

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
  // Of two stations the first has the line.
  Coupling& owner() { return ownsLine_ ? *this : *other_; }
  const Coupling& owner() const { return ownsLine_ ? *this : *other_; }
  Line& line() { return *owner().line_; }
  std::size_t portOf(End end) const {
    return ownsLine_ ? static_cast<std::size_t>(end) : 1 - static_cast<std::size_t>(end);
  }
  Driver& driver() { return powered_ ? static_cast<Driver&>(interface()) : silence_; }
  Settings onWire(Settings settings) const;
  Settings wired() const;
  void connect(Instant now, bool anew = false);
  void build(Instant now);
  void see(Sighting sighting);

  Parameters parameters_;
  Settings partnerSettings_;
  std::unique_ptr<Operation> operation_;
  Silence silence_;
  Partner partner_;
  Coupling* other_ = nullptr;
  Follow follow_;
  bool ownsLine_ = true;
  bool following_ = false;  // of the line's owner: one station waits for the other
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
