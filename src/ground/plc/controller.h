// Any PLC, as scenarios, self-checks, traces and the command line see it.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "address/reference.h"
#include "plc/types.h"

namespace merker::controller {

// How often each line of each source ran.
using ExecutedLines = std::map<std::string, std::map<std::uint32_t, std::uint64_t>>;

class Controller {
 public:
  // How far beyond its end a call may run to reach the end of a cycle that never comes.
  static constexpr Duration kLongestCycle = Duration::seconds(60);

  virtual ~Controller() = default;

  // Of a PLC among others that move through time together: the PLC itself, which has the
  // capabilities.
  virtual Controller& itself() { return *this; }
  virtual const Controller& itself() const { return *this; }

  virtual std::string modelName() const = 0;

  // operating states
  virtual Mode mode() const = 0;
  virtual bool stoppedByFault() const = 0;     // STOP for another reason than a wish
  virtual std::string stopReason() const = 0;  // empty while not in STOP
  virtual bool powered() const = 0;
  virtual bool hasColdRestart() const = 0;
  virtual bool start() = 0;        // as the mode switch or the programmer starts it
  virtual bool warmRestart() = 0;  // false if refused
  virtual bool coldRestart() = 0;
  virtual void stop() = 0;
  virtual void powerOff() = 0;
  virtual void powerOn(bool buffered = true) = 0;  // false: battery empty, RAM is lost
  virtual void memoryReset() = 0;
  // Something goes wrong with the device from now on, or is mended: "" or the reason why not.
  virtual std::string fault(std::string_view /*subject*/, std::string_view /*kind*/, bool /*on*/) {
    return modelName() + " has nothing of this kind";
  }
  // False: it has no battery.
  virtual bool batteryFails(bool /*fails*/) { return false; }

  // time; nothing moves outside these calls
  virtual Instant now() const = 0;
  virtual std::uint64_t cycles() const = 0;
  virtual std::uint64_t instructions() const = 0;
  // Runs up to t exactly, also into the middle of a cycle; in STOP only time moves.
  virtual void advanceTo(Instant t) = 0;
  // On to the end of the cycle that runs now: there values are looked at from outside. False: it
  // has not ended within `longest`; a program may never end it.
  virtual bool settle(Duration longest) = 0;
  void settle() { settle(kLongestCycle); }
  // Fewer if the PLC goes to STOP or a cycle does not come within 60 s.
  virtual void advanceCycles(std::uint64_t count) = 0;
  // To the next cycle checkpoint, at most to `limit`; true if it came to one.
  virtual bool advanceToCheckpoint(Instant limit) = 0;
  // Directly behind a checkpoint: passes over whole cycles that are the same as the one that has
  // ended there, none that ends later than `limit`, and none behind the first that ends at `enough`
  // or later. Nothing can be seen to have happened but that time went on, and with it plants and
  // what counts cycles.
  virtual void passQuietCycles(Instant /*limit*/, Instant /*enough*/) {}
  // Called at each cycle checkpoint: traces look at values here.
  virtual void onCycle(std::function<void(Controller&)> observer) = 0;
  // The same, but for cycles that have changed nothing.
  virtual void onChange(std::function<void(Controller&)> observer) { onCycle(std::move(observer)); }

  // values (bits as 0/1). Reading an input shows its process image, writing it sets its terminal.
  // Nothing, or false, if there is no such operand.
  virtual std::optional<std::uint32_t> read(const address::Reference& reference) const = 0;
  virtual bool write(const address::Reference& reference, std::uint32_t value) = 0;
  virtual bool force(const address::Reference& reference, std::uint32_t value) = 0;
  virtual void unforce() = 0;
  // The bytes of a DATE_AND_TIME or STRING (Reference::bytes), the digits of a datum of the NC.
  virtual std::optional<std::vector<std::uint8_t>> readBytes(const address::Reference&) const {
    return std::nullopt;
  }
  virtual bool writeBytes(const address::Reference&, std::span<const std::uint8_t>) {
    return false;
  }
  // "there is no DB 5", for an operand that cannot be read.
  virtual std::string whyMissing(const address::Reference& reference) const = 0;
  // "it takes 0 and 1", for one that is there and cannot be set; empty: nothing is known.
  virtual std::string whyRefused(const address::Reference&) const { return {}; }
  // The PLC that is coupled with this one and moves through time with it; null: there is none.
  virtual Controller* partner() { return nullptr; }

  virtual const std::vector<DiagnosticEntry>& diagnostics() const = 0;
  virtual const std::vector<CheckResult>& checkResults() const = 0;
  // Empty unless the PLC was built to count; lines that never ran are there with 0.
  virtual ExecutedLines executedLines() const = 0;

 protected:
  Controller() = default;
  Controller(const Controller&) = default;
  Controller& operator=(const Controller&) = default;
  Controller(Controller&&) = default;
  Controller& operator=(Controller&&) = default;
};

}  // namespace merker::controller
