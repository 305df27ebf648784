// Blocks that are translated before the CPU gets them, by whoever has the time for it: the largest
// program takes seconds, and the thread of the PLC has milliseconds.
#pragma once

#include <map>
#include <memory>
#include <stop_token>

#include "block/block.h"
#include "catalogue/cpu_model.h"
#include "cpu/frame.h"
#include "station/engine.h"

namespace merker::station {

class Translations {
 public:
  // The code blocks of `program`; those whose code is as in `before` are left out (null: none is).
  // Those with checks are, too. In any thread; what was done until `stop` is there.
  Translations(const CpuModel& model, Engine engine, std::shared_ptr<const block::Program> program,
               const block::Program* before, const std::stop_token& stop = {});

  // False, whatever was wanted, where there is no compiler for this processor.
  bool compiled() const { return compiled_; }
  // That of a block with this number and this code; null: there is none.
  cpu::Code* find(const block::Block& block) const;
  std::unique_ptr<cpu::Code> take(const block::Block& block);

 private:
  std::shared_ptr<const block::Program> program_;
  bool compiled_;
  std::map<BlockId, std::unique_ptr<cpu::Code>> blocks_;
};

}  // namespace merker::station
