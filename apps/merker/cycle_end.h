// What happens at the end of each cycle of a run: first it is kept on the card, then it is seen
// outside.
#pragma once

#include <fstream>
#include <optional>

#include "card.h"
#include "scenario/trace.h"

namespace merker::app {

class CycleEnd {
 public:
  CycleEnd(store::MemoryCard* card, std::ofstream& file, bool realTime)
      : file_(file), realTime_(realTime) {
    if (card != nullptr) keeper_.emplace(*card);
  }
  void watch(const simulator::Watched& watched, const controller::Controller& plc) {
    moves_ = watched.movesByItself();
    trace_.emplace(file_, watched, plc);
  }
  void operator()(controller::Controller& plc) {
    if (keeper_ && !keeper_->save(plc)) return plc.stop();
    if (!trace_) return;
    trace_->sample(plc);
    if (keeper_ || realTime_)
      file_.flush();  // who reads along sees the cycle as soon as it is kept
  }
  // While no cycle ends.
  void standing(controller::Controller& plc) {
    if (keeper_ && plc.mode() == controller::Mode::Stop) keeper_->saveProgram(plc);
  }
  // Whether it has nothing to do where a cycle changed nothing: a card keeps each cycle.
  bool ofChanges() const { return !keeper_ && !moves_; }
  bool needed() const { return keeper_ || trace_; }
  const Problem* problem() const {
    return keeper_ && keeper_->problem() ? &*keeper_->problem() : nullptr;
  }

 private:
  std::ofstream& file_;
  bool realTime_;
  bool moves_ = false;  // the trace shows what moves by itself
  std::optional<CardKeeper> keeper_;
  std::optional<simulator::Trace> trace_;
};

}  // namespace merker::app
