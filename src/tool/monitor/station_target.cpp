#include "monitor/station_target.h"

#include "cpu/cpu.h"
#include "monitor/frame_variables.h"

namespace merker::monitor {
namespace {

Depth depthOf(const cpu::Machine& m) { return {m.frames.size(), m.levels.size()}; }

class StationSpot final : public Spot {
 public:
  StationSpot(const station::Station& station, cpu::Machine& m, const cpu::Code& loaded,
              std::uint32_t at)
      : Spot(*loaded.source, &loaded, at, depthOf(m)), station_(station), m_(m) {
    errorLevel = !m.levels.empty() && m.levels.back().errorOb;
    levelEnded = m.levelEnded;
    stopped = m.cpu->mode() == cpu::Mode::Stop;
  }

  Registers registers() const override { return toRegisters(m_.registers, m_.fourAccumulators); }
  std::optional<BlockId> caller() const override {
    const cpu::Frame* frame = m_.caller();
    return frame == nullptr ? std::nullopt : std::optional(frame->code->source->id);
  }
  bool hold() override { return m_.cpu->halt(); }
  std::optional<std::uint32_t> value(const ActualOperand& operand) const override {
    return operand.local.empty() ? station_.read(operand.reference) : localBits(m_, operand.local);
  }

 private:
  const station::Station& station_;
  cpu::Machine& m_;
};

}  // namespace

Registers toRegisters(const cpu::Registers& r, bool fourAccumulators) {
  const cpu::StatusWord& s = r.status;
  return {.accumulators = static_cast<std::uint8_t>(fourAccumulators ? 4 : 2),
          .accu = r.accu,
          .cc1 = s.cc1,
          .cc0 = s.cc0,
          .ov = s.ov,
          .os = s.os,
          .orBit = s.orBit,
          .sta = s.sta,
          .rlo = s.rlo,
          .er = s.er,
          .br = s.br,
          .word = s.word(),
          .ar1 = r.ar1,
          .ar2 = r.ar2,
          .db = r.db.number,
          .di = r.di.number};
}

ProgramCode StationTarget::program() const { return station_.program(); }

void StationTarget::probe(const std::function<bool(BlockId)>& wanted, Observer& observer) {
  observer_ = &observer;
  for (const auto& [id, block] : station_.program())
    if (!block.code.empty()) station_.cpu().loadMemory().probe(id, wanted(id) ? this : nullptr);
}

void StationTarget::removeProbes() {
  for (const auto& [id, block] : station_.program()) station_.cpu().loadMemory().probe(id, nullptr);
}

void StationTarget::resume(bool step) { station_.cpu().resume(step); }
void StationTarget::stepGivenUp() { station_.cpu().stepGivenUp(); }

bool StationTarget::executing() const {
  const cpu::Mode mode = station_.cpu().mode();
  return mode == cpu::Mode::Run || mode == cpu::Mode::Startup;
}

void StationTarget::run(Instant limit) {
  while (executing() && station_.now() < limit) station_.cpu().step(limit);
}

void StationTarget::runToCheckpoint(Instant limit) {
  cpu::Cpu& cpu = station_.cpu();
  const std::uint64_t before = cpu.cycle().checkpoints();
  while (executing() && station_.now() < limit && cpu.cycle().checkpoints() == before)
    cpu.step(limit);
}

Depth StationTarget::depth() const { return depthOf(station_.cpu().machine()); }

Registers StationTarget::registers() const {
  const cpu::Machine& m = station_.cpu().machine();
  return toRegisters(m.registers, m.fourAccumulators);
}

std::optional<SourcePlace> StationTarget::position() const {
  const cpu::Cpu& cpu = station_.cpu();
  const cpu::Machine& m = cpu.machine();
  if (m.levels.empty() || m.top->code == nullptr) return std::nullopt;
  const std::uint32_t offset = cpu.mode() == cpu::Mode::Stop ? m.position : cpu.offset(*m.top);
  return sourcePlace(*m.top->code->source, offset);
}

bool StationTarget::before(cpu::Machine& machine, std::uint32_t offset) {
  StationSpot spot(station_, machine, *machine.top->code, offset);
  return observer_->before(spot);
}

void StationTarget::after(cpu::Machine& machine, const cpu::Code& code, std::uint32_t offset) {
  observer_->after(StationSpot(station_, machine, code, offset));
}

}  // namespace merker::monitor
