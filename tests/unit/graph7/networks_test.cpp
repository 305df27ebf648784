// Each pattern of KOP and FUP as a network of networks.awl: what it says in words, and that its
// machine code comes back byte for byte.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "../rows.h"
#include "graph/canonical.h"
#include "graph/fup.h"
#include "graph/kop.h"
#include "graph/read.h"
#include "graph/sentence.h"
#include "graph/write.h"
#include "graph7/network_code.h"
#include "graph7/rules.h"
#include "source/source_file.h"
#include "step7/compiler.h"

namespace merker::graph7 {
namespace {

const step7::Compilation& compilation() {
  static const step7::Compilation result = [] {
    std::ifstream file(MERKER_SOURCE_DIR "/tests/unit/graph7/networks.awl");
    std::stringstream text;
    text << file.rdbuf();
    step7::CompileOptions options;
    options.model = findCpuModel("generic");
    return step7::compile({source::SourceFile("networks.awl", text.str())}, options);
  }();
  return result;
}

const block::Block* findBlock(BlockId id) {
  const auto at = compilation().program.find(id);
  return at == compilation().program.end() ? nullptr : &at->second;
}

std::vector<NetworkCode> networksOf(const block::Block& block,
                                    graph::Language language = graph::Language::German) {
  const awl::Names names(block);
  return networks(
      block, names, findBlock,
      language == graph::Language::German ? Mnemonics::German : Mnemonics::International);
}

std::string described(const NetworkCode& code, graph::Language language) {
  const auto network = graph::read(code.statements, rules());
  if (!network)
    return fmt::format("  AWL: {} {}: {}\n", network.error().statement,
                       graph::name(code.statements[network.error().statement].op),
                       graph::text(network.error().reason));
  std::string out;
  for (const std::string& sentence : graph::sentences(*network, language, language))
    out += "  " + sentence + "\n";
  return out;
}

std::string allDescribed(graph::Language language) {
  std::string out;
  for (const auto& [id, block] : compilation().program) {
    if (block.code.empty()) continue;
    const auto codes = networksOf(block, language);
    EXPECT_EQ(codes.size(), block.networks.size());
    for (std::size_t i = 0; i < codes.size(); ++i)
      out += fmt::format("{} {}: {}\n{}", toString(id), i + 1, block.networks[i].title,
                         described(codes[i], language));
  }
  return out;
}

TEST(Networks, TheSourceHasNoProblems) {
  for (const Problem& problem : compilation().problems.list())
    ADD_FAILURE() << problem.position.line << ": " << problem.message;
}

// S7-EDIT-09, S7-EDIT-10, S7-SETRESET-05, S7-CNT-11, S7-TMR-09
TEST(Networks, SayInGermanWhatTheyDo) {
  merker::test::expectRows("graph7/networks.de.txt", allDescribed(graph::Language::German));
}

// S7-MNE-13
TEST(Networks, SayInEnglishWhatTheyDo) {
  merker::test::expectRows("graph7/networks.en.txt", allDescribed(graph::Language::English));
}

std::string drawn(const NetworkCode& code, graph::Language language, bool kop) {
  const auto network = graph::read(code.statements, rules());
  if (!network) return {};
  const graph::Style style{language};
  if (kop && !graph::fitsKop(*network, rules())) return "(FUP)\n";
  const auto lines = graph::toText(kop ? graph::kop(*network, style) : graph::fup(*network, style));
  std::string out;
  for (const std::string& line : *lines) out += line + "\n";
  return out;
}

std::string allDrawn(graph::Language language, bool kop) {
  std::string out;
  for (const auto& [id, block] : compilation().program) {
    if (block.code.empty()) continue;
    const auto codes = networksOf(block, language);
    for (std::size_t i = 0; i < codes.size(); ++i)
      out += fmt::format("{} {}: {}\n{}\n", toString(id), i + 1, block.networks[i].title,
                         drawn(codes[i], language, kop));
  }
  return out;
}

// S7-EDIT-08, S7-EDIT-15
TEST(Networks, AreDrawnAsLadder) {
  merker::test::expectRows("graph7/networks.kop.txt", allDrawn(graph::Language::German, true));
}

// S7-EDIT-13, S7-EDIT-14
TEST(Networks, AreDrawnAsFunctionBlocks) {
  merker::test::expectRows("graph7/networks.fup.txt", allDrawn(graph::Language::German, false));
}

// S7-MNE-13
TEST(Networks, AreDrawnInEnglish) {
  merker::test::expectRows("graph7/networks.lad.txt", allDrawn(graph::Language::English, true));
}

// The first temporary bit of a network is the first one that it uses.
std::uint32_t firstWire(const graph::Statements& statements) {
  std::uint32_t first = ~0u;
  for (const graph::Statement& statement : statements)
    if (statement.operand.kind == graph::OperandKind::Wire)
      first = std::min(first, statement.operand.number);
  return first;
}

TEST(Networks, AreInTheFormThatIsStored) {
  std::string others;
  for (const auto& [id, block] : compilation().program) {
    if (block.code.empty()) continue;
    const auto codes = networksOf(block);
    for (std::size_t i = 0; i < codes.size(); ++i) {
      const graph::Statements& statements = codes[i].statements;
      const auto network = graph::read(statements, rules());
      if (!network) continue;
      const auto stored = graph::canonical(*network, rules(), firstWire(statements));
      if (graph::write(stored, rules()) != statements)
        others += fmt::format("{} {}: {}\n", toString(id), i + 1, block.networks[i].title);
    }
  }
  // What the programmers of these networks wrote in their own way.
  EXPECT_EQ(others,
            "OB 1 6: a single contact as an AND term\n"
            "OB 1 8: OR that begins with U\n"
            "OB 1 9: brackets in brackets\n"
            "FB 1 1: own data of an FB\n");
}

TEST(Networks, ComeBackByteForByte) {
  int shown = 0;
  for (const auto& [id, block] : compilation().program) {
    if (block.code.empty()) continue;
    for (const NetworkCode& code : networksOf(block)) {
      const auto network = graph::read(code.statements, rules());
      if (!network) continue;
      ++shown;
      const auto bytes = encode(graph::write(*network, rules()));
      ASSERT_TRUE(bytes);
      EXPECT_EQ(*bytes, std::vector<std::uint8_t>(block.code.begin() + code.begin,
                                                  block.code.begin() + code.end))
          << toString(id) << " at " << code.begin;
    }
  }
  EXPECT_GE(shown, 80);
}

}  // namespace
}  // namespace merker::graph7
