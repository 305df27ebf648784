#include "cpu/cpu.h"

#include "cpu/same_code.h"

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
      runtimeMeters_(model.runtimeMeters),
      log_(machine_, clock_),
      modules_(machine_),
      loadMemory_(machine_, engine_),
      retention_(machine_, parameters_, {clock_, log_, runtimeMeters_}),
      cycle_(parameters_, Duration{model.cycleTime}),
      state_(machine_, {log_, modules_, cycle_, runtimeMeters_, cyclePoints_}),
      interrupts_(machine_, clock_, parameters_),
      requests_(machine_, log_, state_, interrupts_.list(), faults_),
      moduleEvents_(machine_, interrupts_.list(), {log_, modules_, state_, requests_, faults_}),
      clockMemory_(parameters_.clockMemory) {
  machine_.cpu = this;
}

bool Cpu::callSystem(BlockId block, std::span<const std::uint32_t> parameters) {
  if (!services_.steady(block))
    machine_.outlook.until(machine_.clock, {.at = Look::At::SystemBlock,
                                            .block = machine_.top->code->source->id,
                                            .offset = machine_.position,
                                            .called = block});
  return services_.call(
      {.cpu = *this, .machine = machine_, .block = block, .parameters = parameters});
}

void Cpu::load(std::shared_ptr<const block::Program> program) {
  loadMemory_.load(std::move(program));
  quiet_.forgetProgram();
  clearStacks();
  clearSystemMemory(Extent::All);
  machine_.dataBlocks.load(*this->program());
}

void Cpu::download(std::shared_ptr<const block::Program> program) {
  loadMemory_.download(std::move(program));
  if (mode() == Mode::Stop || machine_.levels.empty()) activateDownload();
}

// What happened in them has no line of the new text.
void Cpu::noteReplaced(const block::Program& before) {
  std::set<BlockId> blocks;
  const block::Program& now = *loadMemory_.program();
  for (const auto& [id, block] : before) {
    const auto found = now.find(id);
    if (found == now.end() || !sameCode(block, found->second)) blocks.insert(id);
  }
  log_.replaced(blocks);
  state_.replaced(blocks);
}

void Cpu::activateDownload() {
  if (!loadMemory_.downloaded()) return;
  if (mode() == Mode::Stop) clearStacks();  // the interrupted program cannot go on
  const std::shared_ptr<const block::Program> before = loadMemory_.program();
  loadMemory_.activate();
  if (before != nullptr) noteReplaced(*before);
  quiet_.forgetProgram();
  if (mode() != Mode::Stop) interrupts_.update(mode() == Mode::Run);
}

}  // namespace merker::cpu
