// Two ways to the same trees: the text of a program, and the machine code that it compiles to.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "compiled.h"
#include "graph/read.h"
#include "projects.h"

namespace merker::networks {
namespace {

struct Difference {
  std::size_t networks = 0, pictures = 0;
  std::string texts;
};

void compare(const std::string& name, const Network& network, const Compiled& compiled,
             Difference& out) {
  ++out.networks;
  const auto tree = graph::read(compiled.statements, *compiled.rules);
  const auto written = graph::read(network.source.statements, *compiled.rules);
  out.pictures += tree ? 1 : 0;
  const bool same = Outline().of(network.source.statements) == Outline().of(compiled.statements);
  const bool sameTree = static_cast<bool>(tree) == static_cast<bool>(written);
  // The machine code of UC MW 10 has one statement more: an empty list.
  const bool sameLength = network.source.statements.size() == compiled.statements.size();
  const bool sameReason = tree || written || !sameLength ||
                          (tree.error().reason == written.error().reason &&
                           tree.error().statement == written.error().statement);
  if ((tree ? same : true) && sameTree && sameReason) return;
  out.texts += fmt::format("{} network {} (line {}):\n", name, network.number, network.source.code);
  if (!tree) out.texts += fmt::format("compiled: {}\n", graph::text(tree.error().reason));
  if (!written) out.texts += fmt::format("text: {}\n", graph::text(written.error().reason));
  out.texts += fmt::format("--- text\n{}--- compiled\n{}", Outline().of(network.source.statements),
                           Outline().of(compiled.statements));
}

void compare(const compilation::Build& build, Difference& out) {
  if (!build.ok()) return;
  const Surroundings around = surroundingsOf(build);
  for (const source::SourceFile& file : build.project.sources)
    for (const Block& found : blocks(file, around)) {
      const auto compiled = compiledNetworks(build, found.name);
      if (compiled.empty()) continue;
      const auto block = blockAt(file, found.line, around);
      ASSERT_TRUE(block) << file.name() << found.name;
      const std::string name = file.name() + " " + found.name;
      // Machine code does not tell where the first network ends if it has no head.
      const bool headed = block->networks.front().source.headed;
      if (!headed && block->networks.size() == compiled.size() + 1) continue;
      if (block->networks.size() != compiled.size())
        out.texts +=
            fmt::format("{}: {} networks, not {}\n", name, block->networks.size(), compiled.size());
      else
        for (std::size_t i = 0; i < compiled.size(); ++i)
          compare(name, block->networks[i], compiled[i], out);
    }
}

void expectAgreement(const char* folder, const char* extension, std::size_t pictures) {
  Difference difference;
  forEachProject(folder, extension,
                 [&](const compilation::Build& build) { compare(build, difference); });
  EXPECT_EQ(difference.texts, "");
  EXPECT_GE(difference.pictures, pictures) << "of " << difference.networks << " networks";
}

TEST(Agreement, ofTheExamplesOfStep7) { expectAgreement("examples", ".awl", 100); }
TEST(Agreement, ofTheExamplesOfStep5) { expectAgreement("examples", ".s5", 20); }
TEST(Agreement, ofTheTestsOfStep7) { expectAgreement("tests", ".awl", 150); }
TEST(Agreement, ofTheTestsOfStep5) { expectAgreement("tests", ".s5", 20); }

}  // namespace
}  // namespace merker::networks
