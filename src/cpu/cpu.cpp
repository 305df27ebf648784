#include "cpu/cpu.h"

namespace merker::cpu {

Cpu::Cpu(const CpuModel& model, Engine& engine, SystemServices& services, std::int64_t startOfClock)
    : machine_(model), engine_(engine), services_(services), clock_(startOfClock) {
  runtimeMeters_.resize(model.runtimeMeters);
  machine_.cpu = this;
  stopEvent_ = {.event = static_cast<std::uint16_t>(Event::PowerOn)};
}

namespace {

void enter(std::vector<const Code*>& table, std::uint32_t number, const Code* code) {
  if (table.size() <= number) table.resize(number + 1);
  table[number] = code;
}

}  // namespace

void Cpu::load(std::shared_ptr<const block::Program> program) {
  program_ = std::move(program);
  code_.clear();
  machine_.functions.clear();
  machine_.functionBlocks.clear();
  machine_.organizationBlocks.clear();
  for (const auto& [id, source] : *program_) {
    std::vector<const Code*>* table = id.kind == BlockKind::FC   ? &machine_.functions
                                      : id.kind == BlockKind::FB ? &machine_.functionBlocks
                                      : id.kind == BlockKind::OB ? &machine_.organizationBlocks
                                                                 : nullptr;
    if (table == nullptr) continue;
    code_.push_back(engine_.translate(source));
    enter(*table, id.number, code_.back().get());
  }
  clearStacks();
  clearSystemMemory(true);
  machine_.dataBlocks.load(*program_);
}

bool Cpu::callSystem(BlockId block, std::span<const std::uint32_t> parameters) {
  return services_.call(
      {.cpu = *this, .machine = machine_, .block = block, .parameters = parameters});
}

bool Cpu::probe(BlockId block, Probe* probe) {
  for (const auto& code : code_) {
    if (code->source->id != block) continue;
    engine_.probe(*code, probe);
    return true;
  }
  return false;
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
