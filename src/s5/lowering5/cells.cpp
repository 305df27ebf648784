// Timers and counters as long as nothing happens to them (9.3.4, 9.4.4): no edge that starts a
// timer or counts, no reset. That takes the shorter time; whatever does something is the
// processor's.
#include "lowering5/lowering.h"

namespace merker::translate5 {
namespace {

using icode::Item;
using icode::Opcode;
using icode::Space;
using icode::Value;
using mc5::Operation;

// Bits of the word that keep VKE for the next time (OP-33).
constexpr std::uint32_t kUp = 13, kDown = 12, kStart = 11, kEnable = 10;

bool quiet(Lowering& l) {
  l.leaves = true;
  l.to.cost(static_cast<std::uint64_t>(l.times().shortest.ns));
  l.to.set(Item::Or, false);
  l.to.set(Item::Er, false);
  return true;
}

// Not a formal operand.
bool isTold(const Lowering& l) { return isCell(l.operand()) && l.mayLeave(); }

struct Edge {
  std::uint32_t place;
  Value byte, bit;
};
Edge edgeOf(Lowering& l, std::uint32_t bit) {
  const std::uint32_t place = cellPlace(l) + bit / 8;
  const Value byte = l.to.load(Space::Instance, place, 1);
  return {place, byte, l.to.withNumber(Opcode::BitOf, byte, bit % 8)};
}

// VKE does not rise; it may fall.
template <std::uint32_t Bit>
bool noEdge(Lowering& l) {
  if (!isTold(l)) return false;
  icode::Builder& b = l.to;
  const Edge edge = edgeOf(l, Bit);
  const Value vke = b.get(Item::Rlo);
  b.guard(b.orBit(b.notBit(vke), edge.bit));
  b.store(Space::Instance, edge.place, 1, b.make(Opcode::Insert, edge.byte, vke, Bit % 8));
  return quiet(l);
}

// SI and SE stop with VKE = 0: only as long as it stays 1.
bool goesOn(Lowering& l) {
  if (!isTold(l)) return false;
  l.to.guard(l.to.andBit(l.to.get(Item::Rlo), edgeOf(l, kStart).bit));
  return quiet(l);
}

constexpr Row kCellsRows[] = {
    {Operation::TIMER_SI, goesOn},         {Operation::TIMER_SE, goesOn},
    {Operation::TIMER_SV, noEdge<kStart>}, {Operation::TIMER_SS, noEdge<kStart>},
    {Operation::COUNT_UP, noEdge<kUp>},    {Operation::COUNT_DOWN, noEdge<kDown>},
    {Operation::ENABLE, noEdge<kEnable>}};

}  // namespace

std::span<const Row> cellRows() { return kCellsRows; }

bool setCell(Lowering& l) { return noEdge<kStart>(l); }

bool resetCell(Lowering& l) {
  if (!l.mayLeave()) return false;
  l.to.guard(l.to.notBit(l.to.get(Item::Rlo)));
  return quiet(l);
}

}  // namespace merker::translate5
