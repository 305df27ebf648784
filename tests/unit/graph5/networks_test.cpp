// The rules of chapter 10.3 as the networks of networks.s5: how ladder and function blocks show
// them, and that their machine code comes back.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "../rows.h"
#include "graph/fup.h"
#include "graph/kop.h"
#include "graph/read.h"
#include "graph/write.h"
#include "graph5/network_code.h"
#include "graph5/operand_code.h"
#include "graph5/rules.h"
#include "step5/compiler.h"

namespace merker::graph5 {
namespace {

const mc5::Block& block() {
  static const step5::Compilation result = [] {
    std::ifstream file(MERKER_SOURCE_DIR "/tests/unit/graph5/networks.s5");
    std::stringstream text;
    text << file.rdbuf();
    return step5::compile({source::SourceFile("networks.s5", text.str())}, false);
  }();
  for (const Problem& problem : result.problems.list())
    ADD_FAILURE() << problem.position.line << ": " << problem.message;
  return result.program.begin()->second;
}

std::string shown(const NetworkCode& code, bool kop) {
  const auto network = graph::read(code.statements, rules());
  if (!network)
    return fmt::format("AWL: {} {}: {}\n", network.error().statement,
                       graph::name(code.statements[network.error().statement].op),
                       graph::text(network.error().reason));
  if (kop && !graph::fitsKop(*network, rules())) return "FUP only\n";
  const graph::Style style;
  const auto lines = graph::toText(kop ? graph::kop(*network, style) : graph::fup(*network, style));
  std::string out;
  for (const std::string& line : *lines) out += line + "\n";
  return out;
}

std::string allShown(bool kop) {
  std::string out;
  const auto codes = networks(block());
  EXPECT_EQ(codes.size(), block().networks.size());
  for (std::size_t i = 0; i < codes.size(); ++i)
    out += fmt::format("{}: {}\n{}\n", i + 1, block().networks[i].title, shown(codes[i], kop));
  return out;
}

// S5-KOPFUP-01, S5-KOPFUP-05, S5-KOPFUP-06, S5-KOPFUP-07, S5-KOPFUP-08, S5-KOPFUP-09, S5-KOPFUP-10,
// S5-KOPFUP-11, S5-KOPFUP-13, S5-KOPFUP-14, S5-KOPFUP-19, S5-KOPFUP-21, S5-KOPFUP-22, S5-LOAD-10,
// S5-CALL-05
TEST(Networks, AreShownAsLadder) { test::expectRows("graph5/networks.kop.txt", allShown(true)); }

// S5-KOPFUP-12, S5-KOPFUP-15, S5-KOPFUP-16, S5-KOPFUP-17, S5-KOPFUP-18, S5-KOPFUP-20
TEST(Networks, AreShownAsFunctionBlocks) {
  test::expectRows("graph5/networks.fup.txt", allShown(false));
}

// S5-KOPFUP-02
TEST(Networks, ComeBackWordForWord) {
  int count = 0;
  for (const NetworkCode& code : networks(block())) {
    const auto network = graph::read(code.statements, rules());
    if (!network) continue;
    ++count;
    const auto words = encode(graph::write(*network, rules()));
    ASSERT_TRUE(words);
    EXPECT_EQ(*words, std::vector<std::uint16_t>(block().words.begin() + code.begin,
                                                 block().words.begin() + code.end));
  }
  EXPECT_EQ(count, 16);
}

graph::Statement statement(graph::Op op, std::uint32_t bit = 0) {
  graph::Statement out;
  out.op = op;
  const bool plain = op == graph::Op::AND_OPEN || op == graph::Op::CLOSE;
  if (!plain)
    out.operand = operandOf({.kind = mc5::OperandKind::Memory,
                             .area = mc5::Area::Input,
                             .width = mc5::Width::Bit,
                             .bit = static_cast<std::uint8_t>(bit)});
  return out;
}

// An OR in an AND in an OR …
graph::Statements nested(int levels) {
  using graph::Op;
  graph::Statements out{statement(Op::AND)};
  for (int i = 0; i < levels; ++i) {
    out.push_back(statement(Op::AND_OPEN));
    out.push_back(statement(Op::OR, 1));
  }
  for (int i = 0; i < levels; ++i) {
    out.push_back(statement(Op::OR, 2));
    out.push_back(statement(Op::CLOSE));
  }
  out.push_back(statement(Op::ASSIGN, 3));
  return out;
}

// S5-KOPFUP-03
TEST(Networks, HaveEightLevels) {
  EXPECT_TRUE(graph::read(nested(8), rules()));
  const auto refused = graph::read(nested(9), rules());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().reason, graph::Reason::Brackets);
}

bool isForListsOnly(mc5::Operation operation) {
  using mc5::Operation;
  return mc5::info(operation).level == mc5::Level::Supplementary || operation == Operation::STP ||
         (operation >= Operation::ADD_F && operation <= Operation::DIV_G);
}

// S5-STMT-03: the supplementary operations, arithmetic and STP
TEST(Networks, HaveNoElementForMostOperations) {
  int count = 0;
  for (std::size_t i = 0; i < mc5::operations().size(); ++i) {
    const auto operation = static_cast<mc5::Operation>(i);
    if (!isForListsOnly(operation)) continue;
    ++count;
    const graph::Statements list{statement(graph::Op::AND), statement(operationOf(operation)),
                                 statement(graph::Op::ASSIGN)};
    const auto refused = graph::read(list, rules());
    ASSERT_FALSE(refused) << mc5::info(operation).id;
    EXPECT_EQ(refused.error().statement, 1u) << mc5::info(operation).id;
    EXPECT_EQ(refused.error().reason, graph::Reason::Operation) << mc5::info(operation).id;
  }
  EXPECT_GT(count, 50);
}

}  // namespace
}  // namespace merker::graph5
