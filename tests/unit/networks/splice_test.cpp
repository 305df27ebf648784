// Changed statements come into the text as what they are, and what stays is not touched.
#include <gtest/gtest.h>

#include <random>

#include "compiled.h"
#include "graph/write.h"
#include "networks/alignment.h"
#include "networks/text.h"
#include "projects.h"

namespace merker::networks {
namespace {

using graph::Statements;

TextEdit splicedInto(const source::SourceFile& file, const Found& found, std::size_t network,
                     const Statements& now) {
  const Style style = found.text->style();
  return spliced(
      {file, found.block.networks[network].source, now, style, found.text->writer(style), {}});
}

// Some statements are gone, some are there twice, some come from the rest of the block.
Statements changed(const Statements& old, const Statements& others, std::mt19937& random) {
  const auto under = [&random](std::size_t count) { return random() % count; };
  std::vector<std::size_t> order;  // numbers of old ones, behind them those of others
  for (std::size_t i = 0; i < old.size(); ++i) order.push_back(i);
  for (std::size_t n = under(4) + 1; n > 0 && !order.empty(); --n) {
    const auto at = order.begin() + static_cast<std::ptrdiff_t>(under(order.size()));
    switch (under(3)) {
      case 0:
        order.erase(at);
        break;
      case 1:
        order.insert(at, old.size() + under(others.size()));
        break;
      default:
        *at = old.size() + under(others.size());
    }
  }
  Statements out;
  std::map<std::size_t, std::size_t> numbers;
  for (const std::size_t from : order) {
    const graph::Statement& statement = from < old.size() ? old[from] : others[from - old.size()];
    const bool jumps = statement.target >= 0;
    const auto target =
        std::find(order.begin(), order.end(), static_cast<std::size_t>(statement.target));
    if (statement.op == graph::Op::OPEN) continue;  // L DBW 2 behind it is L DB5.DBW 2
    if (jumps && (from >= old.size() || target == order.end())) continue;
    numbers.emplace(from, out.size());
    out.push_back(statement);
  }
  for (graph::Statement& statement : out)
    if (statement.target >= 0)
      statement.target =
          static_cast<std::int32_t>(numbers.at(static_cast<std::size_t>(statement.target)));
  return out;
}

void expectWritten(const source::SourceFile& file, const Surroundings& around, const Found& found,
                   std::size_t network, const Statements& now) {
  const TextEdit edit = splicedInto(file, found, network, now);
  const source::SourceFile after(file.name(), applied(file, edit));
  const auto block = blockAt(after, found.block.line, around);
  ASSERT_TRUE(block);
  const Statements& read = block->networks[network].source.statements;
  ASSERT_EQ(read.size(), now.size()) << applied(file, edit);
  for (std::size_t i = 0; i < now.size(); ++i) {
    EXPECT_TRUE(sameStatement(now[i], read[i]))
        << found.block.name << " " << network << " " << i << "\n"
        << applied(file, edit);
    EXPECT_EQ(now[i].target, read[i].target);
  }
  ASSERT_EQ(block->networks.size(), found.block.networks.size());
  for (std::size_t i = 0; i < block->networks.size(); ++i)
    EXPECT_TRUE(i == network ||
                block->networks[i].source.statements == found.block.networks[i].source.statements);
}

// The new text compiles to these statements. Most random ones do not compile: brackets.
bool compiles(const compilation::Build& build, const source::SourceFile& file, const Found& found,
              std::size_t network, const Statements& now) {
  const std::string text = applied(file, splicedInto(file, found, network, now));
  const auto again =
      compilation::build(project::load(build.project.path, "", {{file.name(), text}}), false);
  if (!again.ok()) return false;
  const auto compiled = compiledNetworks(again, found.block.name);
  if (compiled.size() != found.block.networks.size()) return false;
  EXPECT_EQ(Outline().of(compiled[network].statements), Outline().of(now)) << text;
  return true;
}

void checkAll(const char* extension, std::size_t atLeast) {
  std::size_t count = 0, compiled = 0;
  std::mt19937 random(1);
  forEachProject("examples", extension, [&](const compilation::Build& build) {
    const Surroundings around = surroundingsOf(build);
    for (const source::SourceFile& file : build.project.sources)
      for (const Block& block : blocks(file, around)) {
        const auto found = findBlock(file, block.line, around);
        ASSERT_TRUE(found);
        Statements others;
        for (const Network& network : found->block.networks)
          if (network.tree)
            for (const graph::Statement& s : network.source.statements)
              if (s.op != graph::Op::OPEN) others.push_back(s);  // L DBW 2 behind it is L DB5.DBW 2
        for (std::size_t i = 0; i < found->block.networks.size(); ++i) {
          const Network& network = found->block.networks[i];
          if (!network.tree || network.source.statements.empty()) continue;
          const TextEdit same =
              splicedInto(file, *found, i, graph::write(*network.tree, *block.rules));
          EXPECT_EQ(same.from, same.to);
          EXPECT_TRUE(same.lines.empty());
          for (int n = 0; n < 10; ++n) {
            const Statements now = changed(network.source.statements, others, random);
            expectWritten(file, around, *found, i, now);
            if (n == 0 && compiles(build, file, *found, i, now)) ++compiled;
          }
          ++count;
        }
      }
  });
  EXPECT_GE(count, atLeast);
  EXPECT_GE(compiled, atLeast / 2);
}

TEST(Splice, writesAnyStatementsOfStep7) { checkAll(".awl", 100); }
TEST(Splice, writesAnyStatementsOfStep5) { checkAll(".s5", 20); }

}  // namespace
}  // namespace merker::networks
