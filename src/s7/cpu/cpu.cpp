#include "cpu/cpu.h"

namespace merker::cpu {

Cpu::Cpu(const CpuModel& model, Engine& engine, SystemServices& services, std::int64_t startOfClock)
    : Cpu(model, engine, services, startOfClock, CpuParameters::of(model)) {}

Cpu::Cpu(const CpuModel& model, Engine& engine, SystemServices& services, std::int64_t startOfClock,
         CpuParameters parameters)
    : machine_(model),
      engine_(engine),
      services_(services),
      parameters_(std::move(parameters)),
      modules_(machine_),
      loadMemory_(machine_, engine_),
      clock_(startOfClock),
      clockMemory_(parameters_.clockMemory) {
  machine_.cpu = this;
  runtimeMeters_.resize(model.runtimeMeters);
  stopEvent_ = {.event = static_cast<std::uint16_t>(Event::PowerOn)};
}

bool Cpu::callSystem(BlockId block, std::span<const std::uint32_t> parameters) {
  return services_.call(
      {.cpu = *this, .machine = machine_, .block = block, .parameters = parameters});
}

void Cpu::load(std::shared_ptr<const block::Program> program) {
  loadMemory_.load(std::move(program));
  clearStacks();
  clearSystemMemory(true);
  machine_.dataBlocks.load(*this->program());
}

void Cpu::download(std::shared_ptr<const block::Program> program) {
  loadMemory_.download(std::move(program));
  if (mode_ == Mode::Stop || machine_.levels.empty()) activateDownload();
}

void Cpu::activateDownload() {
  if (!loadMemory_.downloaded()) return;
  if (mode_ == Mode::Stop) clearStacks();  // the interrupted program cannot go on
  loadMemory_.activate();
  if (mode_ != Mode::Stop) updateInterrupts();
}

}  // namespace merker::cpu
