// A machine as a debugger needs it: probes before and after the instructions of chosen blocks,
// holding, and time in small portions. One implementation for each family.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "monitor/call_values.h"
#include "monitor/code_map.h"
#include "monitor/registers.h"
#include "plc/controller.h"

namespace merker::monitor {

// Blocks that run or wait, and priority classes that run or were interrupted.
struct Depth {
  std::size_t frames = 0, levels = 0;
  bool operator==(const Depth&) const = default;
};

// A machine at an instruction of a block that is looked at.
class Spot {
 public:
  Spot(const BlockCode& block, const void* memory, std::uint32_t at, Depth now)
      : code(block), identity(memory), offset(at), depth(now) {}
  virtual ~Spot() = default;
  Spot(const Spot&) = delete;
  Spot& operator=(const Spot&) = delete;

  const BlockCode code;
  const void* const identity;  // of the code as it is in memory: a download replaces it
  const std::uint32_t offset;
  const Depth depth;
  bool errorLevel = false;  // the class that runs was started by an error of the program
  bool levelEnded = false;  // after: the OB of the class has ended
  bool stopped = false;     // after: the machine is in STOP

  virtual Registers registers() const = 0;
  virtual std::optional<BlockId> caller() const = 0;
  // What it holds now; the variables are those of the block that runs.
  virtual std::optional<std::uint32_t> value(const ActualOperand&) const { return std::nullopt; }
  // Before: the machine stops in front of this instruction. False: it cannot just now.
  virtual bool hold() = 0;
};

class Observer {
 public:
  virtual ~Observer() = default;
  // True: the machine holds; the instruction is not executed and costs no time.
  virtual bool before(Spot& spot) = 0;
  // After it, also when it jumped, ended its block or stopped the machine. Not when it opened a
  // block: the next `before` at the same depth then shows what it left behind.
  virtual void after(const Spot& spot) = 0;
};

class Target {
 public:
  virtual ~Target() = default;

  virtual controller::Controller& plc() = 0;
  const controller::Controller& plc() const { return const_cast<Target*>(this)->plc(); }
  // As it is now: a download replaces it.
  virtual ProgramCode program() const = 0;
  // The blocks that `wanted` names are looked at from now on, the others no more.
  virtual void probe(const std::function<bool(BlockId)>& wanted, Observer& observer) = 0;
  virtual void removeProbes() = 0;
  // Out of HALT; of a step, which comes back to it, the diagnostic buffer says nothing.
  virtual void resume(bool step) = 0;
  // The step goes on without an end.
  virtual void stepGivenUp() = 0;
  // To HALT or STOP, at most to `limit`; and at most to the next end of a cycle or change to RUN.
  virtual void run(Instant limit) = 0;
  virtual void runToCheckpoint(Instant limit) = 0;
  virtual Depth depth() const = 0;
  // As they are; in STOP as the program left them.
  virtual Registers registers() const = 0;
  // The next instruction in HALT, the one that failed in STOP; nothing between two cycles.
  virtual std::optional<SourcePlace> position() const = 0;
};

}  // namespace merker::monitor
