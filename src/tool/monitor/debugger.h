// Breakpoints, single step and program status over the probes of a machine (S7-STATE-07). At a
// breakpoint it goes to HALT before the instruction; nothing costs time where nobody looks.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "monitor/program_status.h"

namespace merker::monitor {

struct Breakpoint {
  unsigned number = 0;  // 1, 2 … in the order they were set
  SourcePlace place;
  bool enabled = true;
  std::uint64_t hits = 0;
};

enum class StepKind : std::uint8_t {
  // The end of a block counts as a statement: what the last one left can be looked at there.
  Into,         // the next statement, also in a block that it calls
  Over,         // the next statement of this block, or of its caller
  Out,          // the next statement after this block has ended
  Instruction,  // the next machine instruction
};

// Why time stands.
struct Pause {
  enum class Why : std::uint8_t { Limit, Breakpoint, Step, Stop, Interrupted } why = Why::Limit;
  unsigned breakpoint = 0;  // its number
};

// Sees each instruction of a block: before it, unless the machine holds there, and after it, as
// Observer has it.
class InstructionWatcher {
 public:
  explicit InstructionWatcher(BlockId block) : watched(block) {}
  virtual ~InstructionWatcher() = default;
  virtual void before(const Spot& spot) = 0;
  virtual void after(const Spot& spot) = 0;
  virtual bool wanted() const { return true; }
  const BlockId watched;
};

class Debugger final : private Observer {
 public:
  // The target outlives the debugger.
  explicit Debugger(Target& target);
  ~Debugger() override;
  Debugger(const Debugger&) = delete;
  Debugger& operator=(const Debugger&) = delete;

  // The same place twice is one breakpoint.
  const Breakpoint& setBreakpoint(const SourcePlace& place);
  bool removeBreakpoint(unsigned number);
  bool enableBreakpoint(unsigned number, bool enabled);
  void enableBreakpoints(bool enabled);  // all of them
  void removeBreakpoints();
  const std::vector<Breakpoint>& breakpoints() const { return breakpoints_; }

  // Out of HALT and on, until a breakpoint, STOP, or the limit. `interrupted` is asked now and
  // then.
  Pause run(Instant limit, const std::function<bool()>& interrupted = {});
  Pause step(StepKind kind, Instant limit, const std::function<bool()>& interrupted = {});
  // The machine has gone to STOP: what runs next begins anew.
  void forgetHalt() { leaveFrom_.reset(); }
  // In parts: the step has begun and has not ended at this limit; the next part, the end of it.
  Pause beginStep(StepKind kind, Instant limit);
  Pause stepOn(Instant limit);
  void giveUpStep();
  bool stepping() const { return step_.has_value(); }
  // The same, at most to the next end of a cycle or change to RUN.
  Pause runToCheckpoint(Instant limit);
  // Where the program stands in HALT, or stood at STOP; nothing between two cycles.
  std::optional<SourcePlace> position() const;

  // Program status of this block alone. False: no such block, or it has no code.
  bool showStatus(BlockId block, CallEnvironment environment = {});
  // And of this one: everybody who looks on has a block and an environment of his own.
  bool addStatus(BlockId block, CallEnvironment environment = {},
                 std::vector<CallValues> values = {});
  void hideStatus();
  // Only these stay, with what they have recorded.
  void keepStatus(const std::function<bool(const ProgramStatus&)>& wanted);
  // From now on, as long as it is there; again after a download, and when one has gone.
  void watch(const std::shared_ptr<InstructionWatcher>& watcher);
  void placeWatchers() { place(); }
  // Of the block that was shown first; null if none is.
  const ProgramStatus* status() const { return statuses_.empty() ? nullptr : &statuses_.front(); }
  const ProgramStatus* status(BlockId block, CallEnvironment environment = {}) const;

 private:
  struct Step {
    StepKind kind;
    Depth depth;  // when it began
  };
  struct At {
    BlockId block;
    const void* code;
    std::uint32_t offset;
    std::size_t frames;
    bool operator==(const At&) const = default;
  };
  void setStep(StepKind kind);
  void goOn();
  bool executing() const;
  Pause proceed(Instant limit, const std::function<bool()>& interrupted);
  Pause advance(Instant limit, const std::function<bool()>& interrupted);
  Pause reason() const;
  bool before(Spot& spot) override;
  void after(const Spot& spot) override;
  bool holdAt(Spot& spot, const At& here, Breakpoint* stop);
  bool stepEnds(const Spot& spot) const;
  Breakpoint* breakpointAt(BlockId block, std::uint32_t offset);
  void place();  // probes where they are needed
  void tellStatuses(const Spot& spot, void (ProgramStatus::*what)(const Spot&));
  void tellWatchers(const Spot& spot, void (InstructionWatcher::*what)(const Spot&));

  Target& target_;
  std::vector<Breakpoint> breakpoints_;
  unsigned nextNumber_ = 1;
  std::vector<ProgramStatus> statuses_;  // of different blocks or environments
  std::vector<std::weak_ptr<InstructionWatcher>> watchers_;
  std::optional<Step> step_;
  std::optional<At> heldAt_;     // the instruction that HALT stands before
  std::optional<At> leaveFrom_;  // the same, out of HALT: executed before anything holds again
  Pause pause_;
};

}  // namespace merker::monitor
