#include "cpu/cpu.h"

#include <algorithm>

#include "cpu/clock_memory.h"

namespace merker::cpu {

Cpu::Cpu(const CpuModel& model, Engine& engine, SystemServices& services, std::int64_t startOfClock)
    : Cpu(model, engine, services, startOfClock, CpuParameters::of(model)) {}

Cpu::Cpu(const CpuModel& model, Engine& engine, SystemServices& services, std::int64_t startOfClock,
         CpuParameters parameters)
    : machine_(model),
      engine_(engine),
      services_(services),
      parameters_(std::move(parameters)),
      clock_(startOfClock),
      nextClockMemory_(parameters_.clockMemory ? nextClockMemory(Instant{}) : Instant::never()) {
  machine_.cpu = this;
  runtimeMeters_.resize(model.runtimeMeters);
  stopEvent_ = {.event = static_cast<std::uint16_t>(Event::PowerOn)};
}

void Cpu::connect(Periphery* periphery) {
  periphery_ = periphery;
  if (periphery_ != nullptr) periphery_->disableOutputs(*this, outputsDisabled_);
}

bool Cpu::callSystem(BlockId block, std::span<const std::uint32_t> parameters) {
  return services_.call(
      {.cpu = *this, .machine = machine_, .block = block, .parameters = parameters});
}

bool Cpu::probe(BlockId block, Probe* probe) {
  const auto newest = std::find_if(code_.rbegin(), code_.rend(),
                                   [&](const auto& code) { return code->source->id == block; });
  if (newest == code_.rend()) return false;
  engine_.probe(**newest, probe);
  return true;
}

void Cpu::force(std::uint32_t imageByte, std::uint8_t mask, std::uint8_t value) {
  forces_.push_back({imageByte, mask, value});
}

void Cpu::unforce(std::uint32_t imageByte, std::uint8_t mask) {
  for (Force& force : forces_)
    if (force.byte == imageByte) force.mask = static_cast<std::uint8_t>(force.mask & ~mask);
  std::erase_if(forces_, [](const Force& force) { return force.mask == 0; });
}

}  // namespace merker::cpu
