#include "stand.h"

#include <map>

namespace merker::differential {
namespace {

// Clearing 64 KiB of each area and as many timers would take longer than the programs.
CpuModel smallGeneric() {
  CpuModel model = *findCpuModel("generic");
  model.flagBytes = model.imageBytes = 512;
  model.peripheralBytes = 1024;
  model.localBytes = 4096;
  model.timers = model.counters = 64;
  return model;
}

}  // namespace

const CpuModel* findModel(const std::string& name) {
  static const CpuModel kSmallGeneric = smallGeneric();
  return name == "small generic" ? &kSmallGeneric : findCpuModel(name);
}

Stand::Stand(const Engine& engine)
    : compiles_(engine.compiled),
      model_(*findModel(engine.model)),
      engine_(model_, engine.compiled,
              {.jit = {.broken = engine.broken, .slots = engine.slots}, .shortestEntry = 1}),
      services_(model_) {}

cpu::Cpu& Stand::load(std::shared_ptr<const block::Program> program,
                      const CpuParameters& parameters) {
  services_.restart();
  cpu_.emplace(model_, engine_, services_, 0, parameters);
  engine_.compile(compiles_, *cpu_);
  cpu_->load(std::move(program));
  return *cpu_;
}

Stand& stand(const Engine& engine) {
  static std::map<Engine, Stand> stands;
  return stands.try_emplace(engine, engine).first->second;
}

}  // namespace merker::differential
