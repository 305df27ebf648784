#include "served/block_task.h"

#include "base/bytes.h"

namespace merker::served {

using monitor::Spot;
using s7comm::BlockWatch;
using s7comm::TestRegisters;

BlockId watchedBlock(const BlockWatch& watch) {
  return {static_cast<BlockKind>(watch.type), watch.number};
}

TestRegisters testRegisters(const monitor::Registers& registers) {
  return {.status = registers.word,
          .accu1 = registers.accu[0],
          .accu2 = registers.accu[1],
          .ar1 = registers.ar1.value_or(0),
          .ar2 = registers.ar2.value_or(0),
          .db = registers.db,
          .di = registers.di.value_or(0)};
}

BlockTask::BlockTask(std::shared_ptr<s7comm::Outlet> client, s7comm::TestJob job,
                     monitor::Monitor& monitor)
    : TestTask(std::move(client), std::move(job)),
      InstructionWatcher(watchedBlock(TestTask::job().block)),
      monitor_(monitor) {}

void BlockTask::end(monitor::Monitor& monitor) {
  gone_ = true;
  monitor.debugger().placeWatchers();
}

void BlockTask::enable(bool on) {
  TestTask::enable(on);
  if (on) monitor_.debugger().placeWatchers();
}

// Calls of the block within the one that is watched, and in interrupts, do not count.
bool BlockTask::isInside(const Spot& spot) const {
  return recording_ && spot.depth.frames > running_;
}

bool BlockTask::isWanted(const Spot& spot) const {
  const BlockWatch& watch = job().block;
  if (watch.caller &&
      spot.caller() != BlockId{static_cast<BlockKind>(watch.caller->type), watch.caller->number})
    return false;
  const monitor::Registers registers = spot.registers();
  return (!watch.db || registers.db == *watch.db) && (!watch.di || registers.di == watch.di);
}

void BlockTask::beginCall(const Spot& spot) {
  recording_ = enabled() && isWanted(spot);
  running_ = spot.depth.frames;
  underWay_.reset();
  seen_.clear();
  first_ = testRegisters(spot.registers());
}

// An instruction that opened a block is done when the next one of this call begins.
void BlockTask::before(const Spot& spot) {
  if (isInside(spot)) return;
  if (spot.offset == 0 && running_ != spot.depth.frames) beginCall(spot);
  if (!recording_) return;
  found_ = testRegisters(spot.registers());
  if (underWay_) record(*underWay_, found_);
  if (spot.offset == job().block.begin) first_ = found_;
  underWay_ = spot.offset;
}

// The end of a block gives its caller registers back: it shows what it found.
void BlockTask::after(const Spot& spot) {
  if (isInside(spot)) return;
  const bool ended = spot.levelEnded || spot.depth.frames < running_;
  if (recording_) record(spot.offset, ended ? found_ : testRegisters(spot.registers()));
  underWay_.reset();
  if (ended || spot.stopped) endCall();
}

void BlockTask::record(std::uint32_t address, const TestRegisters& registers) {
  seen_[address] = registers;
}

void BlockTask::endCall() {
  running_ = 0;
  if (!std::exchange(recording_, false)) return;
  s7comm::Bytes data;
  appendWord(data, job().block.begin);
  s7comm::appendRegisters(data, first_, job().block.registers);
  for (const BlockWatch::Line& line : job().block.lines) {
    const auto found = seen_.find(line.address);
    if (found == seen_.end()) continue;
    appendWord(data, line.address);
    s7comm::appendRegisters(data, found->second, line.registers);
  }
  TestTask::enable(false);
  over_ = job().often == 1;
  tell(data);
}

}  // namespace merker::served
