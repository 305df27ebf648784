// The signal that a ladder shows at each wire, by the status bits of a CPU that runs it: the
// current goes through a contact that is closed, and what comes to the coil is the truth.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "../interpreter/rig.h"
#include "graph/canonical.h"
#include "graph/fup.h"
#include "graph/kop.h"
#include "graph/read.h"
#include "graph/write.h"
#include "graph7/network_code.h"
#include "graph7/rules.h"
#include "mc7/listing.h"
#include "trees.h"

namespace merker::graph7 {
namespace {

using graph::Shape;
using graph::ShapeKind;

// Behind each statement.
std::vector<cpu::StatusWord> statusOf(const graph::Statements& statements, unsigned inputs) {
  using interpreter::test::word;
  std::vector<mc7::Instruction> program{
      {mc7::Operation::LOAD, word(inputs)},
      {mc7::Operation::TRANSFER, mc7::memory(Area::Flag, Width::Byte, 0)}};
  const auto listing = mc7::list(encode(statements).value());
  for (const mc7::Place& place : listing.places) program.push_back(place.instruction);
  interpreter::test::Rig rig(program);
  rig.start();
  rig.step(2);
  std::vector<cpu::StatusWord> out;
  for (std::size_t i = 0; i < statements.size(); ++i) {
    rig.step();
    out.push_back(rig.status());
  }
  return out;
}

// The signals at the wires of a picture, by the places between its columns.
class Signals {
 public:
  Signals(const graph::Picture& picture, const std::vector<cpu::StatusWord>& status) {
    for (const Shape& shape : picture.shapes) {
      if (shape.kind != ShapeKind::Wire || shape.w == 0) continue;
      const bool on = isOn(shape.flow, status);
      begins_[{shape.y, shape.x}] = on;
      ends_[{shape.y, shape.x + shape.w}] = on;
    }
  }

  // What comes to a box at its only input; a circle before it turns it round.
  bool into(const Shape& frame) const {
    for (const auto& [place, on] : ends_)
      if (place.first > frame.y && place.first < frame.y + frame.h)
        if (place.second == frame.x || place.second == frame.x - 1)
          return on != (place.second == frame.x - 1);
    return ends_.at({frame.y, frame.x});
  }
  bool before(const Shape& symbol) const { return ends_.at({symbol.y, symbol.x}); }
  bool behind(const Shape& symbol) const { return begins_.at({symbol.y, symbol.x + symbol.w}); }

 private:
  static bool isOn(const graph::Flows& flows, const std::vector<cpu::StatusWord>& status) {
    return std::all_of(flows.begin(), flows.end(), [&status](const graph::Flow& flow) {
      const cpu::StatusWord& bits = status[flow.statement];
      return flow.bit == graph::FlowBit::Vke ? bits.rlo
                                             : bits.sta != (flow.bit == graph::FlowBit::NotSta);
    });
  }

  std::map<std::pair<int, int>, bool> begins_, ends_;
};

void expectCurrent(const graph::Network& network, unsigned inputs) {
  const graph::Statements statements = graph::write(network, rules());
  const graph::Picture picture = graph::kop(network, {});
  const Signals signals(picture, statusOf(statements, inputs));
  for (const Shape& shape : picture.shapes) {
    if (shape.kind == ShapeKind::Coil)
      RC_ASSERT(signals.before(shape) == test::evaluate(network, inputs));
    if (shape.kind != ShapeKind::Contact) continue;
    const bool before = signals.before(shape);
    const graph::Operand& operand = statements[static_cast<std::size_t>(shape.of.node)].operand;
    const bool closed = (((inputs >> operand.number) & 1u) != 0) != (shape.text == "/");
    RC_ASSERT(signals.behind(shape) == (shape.text == "NOT" ? !before : before && closed));
  }
}

// What comes to the box of the coil.
void expectSignal(const graph::Network& network, unsigned inputs) {
  const graph::Statements statements = graph::write(network, rules());
  const graph::Picture picture = graph::fup(network, {});
  const Signals signals(picture, statusOf(statements, inputs));
  for (const Shape& shape : picture.shapes)
    if (shape.kind == ShapeKind::Frame && shape.of.node == static_cast<int>(statements.size()) - 1)
      RC_ASSERT(signals.into(shape) == test::evaluate(network, inputs));
}

RC_GTEST_PROP(Flow, ComesToTheCoilOfFunctionBlocks, ()) {
  const graph::Network network = graph::canonical(*test::unmarkedNetworks(), rules(), 0);
  const auto numbered = graph::read(graph::write(network, rules()), rules());
  RC_ASSERT(numbered.has_value());
  for (unsigned inputs = 0; inputs < 1u << test::kInputs; ++inputs) expectSignal(*numbered, inputs);
}

RC_GTEST_PROP(Flow, IsTheCurrentOfTheLadder, ()) {
  const graph::Network network = graph::canonical(*test::unmarkedNetworks(), rules(), 0);
  if (!graph::fitsKop(network, rules())) return;
  const auto numbered = graph::read(graph::write(network, rules()), rules());
  RC_ASSERT(numbered.has_value());
  for (unsigned inputs = 0; inputs < 1u << test::kInputs; ++inputs)
    expectCurrent(*numbered, inputs);
}

}  // namespace
}  // namespace merker::graph7
