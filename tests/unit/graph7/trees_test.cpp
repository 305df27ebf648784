// Random trees: they come back as they were, and a CPU that runs them agrees with their truth
// table.
#include "trees.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "../interpreter/rig.h"
#include "graph/canonical.h"
#include "graph/read.h"
#include "graph/write.h"
#include "graph7/network_code.h"
#include "graph7/rules.h"

namespace merker::graph7 {
namespace {

using interpreter::test::Rig;

constexpr unsigned kCombinations = 1u << test::kInputs, kResults = 10;  // MB 10: the first results

// The statements as the networks of a block come: through machine code.
graph::Statements throughCode(const graph::Statements& statements) {
  block::Block block;
  block.id = {BlockKind::FC, 1};
  block.code = encode(statements).value();
  const awl::Names names(block);
  return networks(block, names, {}, Mnemonics::German).front().statements;
}

// The network once for each combination of inputs, each with a coil of its own.
block::Block allCombinations(graph::Network network) {
  block::Block block = interpreter::test::codeBlock(BlockKind::FC, 1, {});
  for (unsigned inputs = 0; inputs < kCombinations; ++inputs) {
    const auto set = interpreter::test::assemble(
        {{mc7::Operation::LOAD, interpreter::test::word(inputs)},
         {mc7::Operation::TRANSFER, mc7::memory(Area::Flag, Width::Byte, 0)}});
    network.rungs.front().coils.front().operand = test::flag(kResults + inputs / 8, inputs % 8);
    const auto code = encode(graph::write(network, rules())).value();
    block.code.insert(block.code.end(), set.begin(), set.end());
    block.code.insert(block.code.end(), code.begin(), code.end());
  }
  (void)mc7::encode({mc7::Operation::BE, {}}, block.code);
  return block;
}

RC_GTEST_PROP(Trees, ComeBack, ()) {
  const graph::Network network = *test::networks();
  const auto again = graph::read(throughCode(graph::write(network, rules())), rules());
  RC_ASSERT(again.has_value());
  RC_ASSERT(*again == network);
}

// `network` runs as the truth table of `meant` says.
void expectTruth(const graph::Network& network, const graph::Network& meant) {
  Rig rig({{mc7::Operation::UC, mc7::blockOperand(BlockKind::FC, 1)}}, {allCombinations(network)});
  rig.start();
  rig.finish();
  RC_ASSERT(!rig.stopped());
  for (unsigned inputs = 0; inputs < kCombinations; ++inputs) {
    const std::uint32_t results = *rig.machine().areas.flag(kResults + inputs / 8);
    RC_ASSERT(((results >> (inputs % 8)) & 1u) == (test::evaluate(meant, inputs) ? 1u : 0u));
  }
}

// S7-EDIT-14, S7-EDIT-15
RC_GTEST_PROP(Trees, RunAsTheirTruthTable, ()) {
  const graph::Network network = *test::networks();
  expectTruth(network, network);
}

RC_GTEST_PROP(Trees, MeanTheSameInTheFormThatIsStored, ()) {
  const graph::Network network = *test::unmarkedNetworks();
  expectTruth(graph::canonical(network, rules(), 0), network);
}

}  // namespace
}  // namespace merker::graph7
