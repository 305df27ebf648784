// The data exchange of a DP master with its slaves: outputs that the CPU has written reach a slave,
// and inputs of it reach the CPU, at the end of the slave's turn in the bus cycle. Nothing is done
// in turns that change nothing, so an idle bus costs no time.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "io/rack.h"
#include "profibus/bus_cycle.h"

namespace merker::profibus {

// SFC 11: what a global control telegram can say.
enum class Control : std::uint8_t { Unfreeze = 4, Freeze = 8, Unsync = 16, Sync = 32 };

class Exchange {
 public:
  explicit Exchange(io::Rack& rack);

  bool any() const { return !slaves_.empty(); }
  const io::DpMaster& master() const { return *rack_.configuration().dp; }
  // Whether this byte is a slave's.
  bool ownsInput(std::uint32_t byte) const { return ownerOf(inputOwners_, byte) != kNobody; }
  bool ownsOutput(std::uint32_t byte) const { return ownerOf(outputOwners_, byte) != kNobody; }

  // At `now`: bytes of slaves that have changed at their terminals, or in the CPU.
  void inputChanged(std::uint32_t byte, Instant now) { changed(inputOwners_, byte, now); }
  void written(std::uint32_t byte, std::uint8_t value, Instant now);

  // The next turn of this slave begins: at `now` or later.
  Instant turnBegins(std::size_t slave, Instant now) const {
    return inGrid(cycle_.begins[slave], Instant{now.ns - 1});
  }

  Instant next() const { return next_; }  // the next turn that changes something
  // Turns up to `now`: outputs go to the rack; returns which input bytes the CPU gets to see.
  std::vector<io::Bytes> advance(Instant now);

  // All slaves of these groups get the commands; those that do not know one go on as before.
  void control(std::uint8_t groups, std::uint8_t commands, Instant now);

 private:
  static constexpr std::uint8_t kNobody = 0xFF;
  struct Turn {
    std::vector<io::Bytes> inputs, outputs;  // of its modules
    Instant due = Instant::never();
    bool frozen = false, synced = false;
    bool freezeNow = false, syncNow = false;  // one exchange in spite of it
  };
  static std::uint8_t ownerOf(const std::vector<std::uint8_t>& owners, std::uint32_t byte) {
    return byte < owners.size() ? owners[byte] : kNobody;
  }
  void changed(const std::vector<std::uint8_t>& owners, std::uint32_t byte, Instant now);
  void require(std::size_t slave, Instant now);
  Instant turnAfter(std::size_t slave, Instant now) const {
    return inGrid(cycle_.ends[slave], now);
  }
  Instant inGrid(Duration first, Instant now) const;
  void exchange(Turn& turn, std::vector<io::Bytes>& seen);

  io::Rack& rack_;
  BusCycle cycle_{};
  std::vector<Turn> slaves_;
  std::vector<std::uint8_t> inputOwners_, outputOwners_;  // by byte
  std::vector<std::uint8_t> staged_;                      // outputs as the CPU wrote them
  Instant next_ = Instant::never();
};

}  // namespace merker::profibus
