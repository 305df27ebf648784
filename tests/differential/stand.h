// A CPU with one engine, used again for one program after the other.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "block/block.h"
#include "icode/region.h"
#include "station/mixed_engine.h"
#include "system/services.h"

namespace merker::differential {

struct Engine {
  std::string model;
  bool compiled = true;
  std::optional<icode::Opcode> broken{};  // this emitter gives wrong code
  std::uint32_t slots = UINT32_MAX;       // for values that find no register
  auto operator<=>(const Engine&) const = default;
};

// Models of the catalogue, and "small generic": what random programs reach of the generic CPU.
const CpuModel* findModel(const std::string& name);

class Stand {
 public:
  explicit Stand(const Engine& engine);
  // A new CPU with this program, in STOP; the one before is gone.
  cpu::Cpu& load(std::shared_ptr<const block::Program> program, const CpuParameters& parameters);
  // The program stands somewhere: it goes on with the other engine.
  void compileAfter(std::uint64_t instructions) { engine_.compileAfter(instructions); }
  void switchEngine() { engine_.compile(!engine_.compiles(), *cpu_); }

 private:
  const bool compiles_;
  const CpuModel& model_;
  station::MixedEngine engine_;
  system::Services services_;
  std::optional<cpu::Cpu> cpu_;
};

// Always the same one of an engine.
Stand& stand(const Engine& engine);

}  // namespace merker::differential
