// The third seam of the CPU: the modules. What they show lies in Areas::inputs, what the CPU gives
// them in Areas::outputs; through this the modules learn of writes and can act on their own time.
#pragma once

#include <cstdint>
#include <string_view>

#include "clock/instant.h"

namespace merker::cpu {

class Cpu;

class Periphery {
 public:
  virtual ~Periphery() = default;
  // When a module acts by itself next; Instant::never() if none will. The CPU calls `advance` at
  // the first instruction boundary at or after it, in every operating state.
  virtual Instant next() const = 0;
  // For messages: who acts at `now`.
  virtual std::string_view due(Instant) const { return "modules"; }
  // Brings Areas::inputs to `now` and hands events to Cpu::moduleEvents.
  virtual void advance(Cpu& cpu, Instant now) = 0;
  // Areas::inputs are about to be read, by the process image or the program (L PEx): what modules
  // work out only when asked.
  virtual void reading(Cpu& /*cpu*/) {}
  // The same for what the CPU can notice, as long as it changes no output; not before next().
  // `access`: its program reads inputs behind the process image.
  virtual Instant nextVisible(bool /*access*/) const { return next(); }
  // How the last `advance` could be noticed.
  enum class Notice : std::uint8_t { No, ByAccess, Anyhow };
  virtual Notice noticed() const { return Notice::Anyhow; }
  // Time has passed without an instruction, up to before nextVisible().
  virtual void passed(Cpu& /*cpu*/, Instant /*now*/) {}
  // Whether nothing that `reading` shows moves between two instants named by `next`.
  virtual bool steady() const { return false; }
  // OB 40 of the module at this address has ended, or does not come.
  virtual void acknowledged(Cpu& /*cpu*/, std::uint32_t /*address*/) {}
  // The operating state is another one now.
  virtual void modeChanged(Cpu& /*cpu*/) {}
  // The program (T PAx) or the process image wrote outputs.first .. first + count - 1.
  virtual void written(Cpu& cpu, std::uint32_t first, std::uint32_t count) = 0;
  // The CPU's line "output disable": on in STOP, STARTUP and HALT. Modules then put out 0 or their
  // substitute values (S7-STATE-02, -11).
  virtual void disableOutputs(Cpu& cpu, bool disabled) = 0;
  // Power goes or returns (S7-STATE-05).
  virtual void supply(Cpu&, bool) {}
  // The CPU has gone to RUN, with parameters that its start has set: modules report what is wrong
  // with them (S7-ERR-05).
  virtual void started(Cpu&) {}
};

}  // namespace merker::cpu
