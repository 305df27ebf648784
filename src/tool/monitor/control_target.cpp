#include "monitor/control_target.h"

#include <algorithm>

#include "mc5/block_id.h"

namespace merker::monitor {
namespace {

using sinumerik::CodePlace;

BlockCode codeAt(const ProgramCode& program, BlockId id) {
  static const mc5::Block kNone;
  return program.find(id).value_or(BlockCode(kNone));
}

// FEHLCODE is the number of the alarm without 6000.
bool isBetween(const sinumerik::FineCode& fine) {
  using enum sinumerik::Alarm;
  constexpr sinumerik::Alarm kBetween[] = {ProgrammerStop, CycleTime, ProcessingDelay,
                                           InterruptStack};
  const auto alarm = static_cast<sinumerik::Alarm>(6000 + fine.code);
  return std::ranges::find(kBetween, alarm) != std::end(kBetween);
}

class ControlSpot final : public Spot {
 public:
  ControlSpot(const sinumerik::Machine& m, const BlockCode& block, const CodePlace& place,
              const sinumerik::Registers& registers)
      : Spot(block, nullptr, place.offset, {place.frames, place.levels}),
        m_(m),
        registers_(registers) {}

  Registers registers() const override {
    const bool runs = !m_.levels.empty() && !m_.levels.back().frames.empty();
    return toRegisters(registers_, runs ? openBlock(m_.levels.back().frames.back()) : 0);
  }
  std::optional<BlockId> caller() const override {
    const auto& frames = m_.levels.back().frames;
    if (frames.size() < 2) return std::nullopt;
    return mc5::neutralId(frames[frames.size() - 2].block);
  }
  bool hold() override { return true; }

 private:
  const sinumerik::Machine& m_;
  const sinumerik::Registers& registers_;
};

}  // namespace

std::uint16_t openBlock(const sinumerik::Frame& frame) {
  return frame.data.open ? frame.data.number : std::uint16_t{0};
}

Registers toRegisters(const sinumerik::Registers& r, std::uint16_t db) {
  const sinumerik::Displays& d = r.displays;
  return {.accumulators = 2,
          .accu = {r.akku1, r.akku2},
          .cc1 = d.anz1,
          .cc0 = d.anz0,
          .ov = d.ov,
          .os = d.os,
          .orBit = d.orBit,
          .sta = d.status,
          .rlo = d.vke,
          .er = d.chain,
          .br = {},
          .word = d.byte(),
          .ar1 = {},
          .ar2 = {},
          .db = db,
          .di = {}};
}

// Bits of the byte as in Displays::byte().
Registers toRegisters(const sinumerik::InterruptStack& stack) {
  const auto bit = [&](unsigned number) { return (stack.displays >> number & 1) != 0; };
  return {.accumulators = 2,
          .accu = {stack.akku1, stack.akku2},
          .cc1 = bit(7),
          .cc0 = bit(6),
          .ov = bit(5),
          .os = bit(4),
          .orBit = bit(3),
          .sta = bit(2),
          .rlo = bit(1),
          .er = bit(0),
          .br = {},
          .word = stack.displays,
          .ar1 = {},
          .ar2 = {},
          .db = stack.dataBlock.value_or(0),
          .di = {}};
}

ProgramCode ControlTarget::program() const { return std::as_const(control_).plc().program(); }

void ControlTarget::probe(const std::function<bool(BlockId)>& wanted, Observer& observer) {
  observer_ = &observer;
  for (const auto& [id, block] : control_.plc().program())
    if (id.type != mc5::BlockType::Db)
      control_.plc().probe(id, wanted(mc5::neutralId(id)) ? this : nullptr);
}

void ControlTarget::removeProbes() {
  for (const auto& [id, block] : control_.plc().program()) control_.plc().probe(id, nullptr);
}

void ControlTarget::resume(bool) { control_.resume(); }
void ControlTarget::stepGivenUp() {}
void ControlTarget::run(Instant limit) { control_.runTo(limit); }
void ControlTarget::runToCheckpoint(Instant limit) { control_.runToCheckpoint(limit); }

Depth ControlTarget::depth() const {
  const auto place = control_.plc().place();
  return place ? Depth{place->frames, place->levels} : Depth{};
}

Registers ControlTarget::registers() const {
  const sinumerik::Plc& plc = control_.plc();
  const sinumerik::Machine& m = plc.machine();
  if (m.levels.empty() || m.levels.back().frames.empty())
    return toRegisters(plc.operatingSystem().record().picture().interrupt);
  return toRegisters(m.levels.back().registers, openBlock(m.levels.back().frames.back()));
}

// In STOP the levels are gone; the picture of the STOP has the place.
std::optional<SourcePlace> ControlTarget::position() const {
  const sinumerik::Plc& plc = control_.plc();
  if (plc.mode() == sinumerik::Mode::Stop) return stopped();
  const auto place = plc.place();
  if (!place) return std::nullopt;
  const BlockId id = mc5::neutralId(place->block);
  return sourcePlace(program(), id, place->offset);
}

// REL-SAZ is behind the instruction that stopped the PLC; what came between two instructions
// stopped it in front of the next one.
std::optional<SourcePlace> ControlTarget::stopped() const {
  const sinumerik::AlarmRecord& record = control_.plc().operatingSystem().record();
  const sinumerik::InterruptStack& picture = record.picture().interrupt;
  if (!picture.block) return std::nullopt;
  const BlockId id = mc5::neutralId(*picture.block);
  const std::uint32_t behind = picture.relativeStep;
  if (isBetween(record.fineCode())) return sourcePlace(program(), id, behind);
  const auto code = program().find(id);
  return sourcePlace(program(), id, code && behind > 0 ? code->instructionAt(behind - 1) : behind);
}

bool ControlTarget::before(const sinumerik::Machine& machine, const CodePlace& place) {
  ControlSpot spot(machine, codeAt(program(), mc5::neutralId(place.block)), place,
                   machine.levels.back().registers);
  return observer_->before(spot);
}

void ControlTarget::after(const sinumerik::Machine& machine, const CodePlace& place,
                          const sinumerik::Passed& passed) {
  CodePlace now = place;
  if (passed.blockEnded || passed.levelEnded) --now.frames;
  ControlSpot spot(machine, codeAt(program(), mc5::neutralId(place.block)), now, passed.registers);
  spot.levelEnded = passed.levelEnded;
  spot.stopped = passed.trapped;
  observer_->after(spot);
}

}  // namespace merker::monitor
