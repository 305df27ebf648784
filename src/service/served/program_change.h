// A change of the program of a CPU by a client: planned and carried out in the thread of the PLC,
// which has milliseconds; made ready in that of the connections (docs/safety.md).
#pragma once

#include <memory>
#include <vector>

#include "block/block.h"
#include "s7comm/block_store.h"
#include "station/block_cpu.h"

namespace merker::served {

struct ProgramChange {
  s7comm::Error error = s7comm::Error::None;
  std::string password{};
  // As long as these are the same, what was made ready fits.
  std::shared_ptr<const block::Program> before{};
  station::Engine engine = station::Engine::Interpreter;
  const CpuModel* model = nullptr;

  std::vector<std::shared_ptr<const block::Block>> linked{};
  std::vector<BlockId> deleted{};
  std::vector<BlockId> noLongerPassive{};

  std::shared_ptr<const block::Program> after{};
  std::shared_ptr<station::Translations> translations{};

  void makeReady();
  bool changesProgram() const { return !linked.empty() || !deleted.empty(); }
};

}  // namespace merker::served
