// The table of operations: well-formed rows and the way from a mnemonic to its operation.
#include <gtest/gtest.h>

#include <set>

#include "mc7/encoding.h"

namespace merker::mc7 {
namespace {

TEST(Operations, StatusColumnsHaveNineKnownMarks) {
  for (const OperationInfo& row : operations()) {
    EXPECT_EQ(row.status.size(), 9u) << row.id;
    EXPECT_EQ(row.status.find_first_not_of("-01x"), std::string_view::npos) << row.id;
    EXPECT_FALSE(row.source.empty()) << row.id;
  }
}

// S7-INSTR-130: every instruction has a code.
TEST(Operations, EveryOperationHasACode) {
  std::set<Operation> coded;
  for (const Encoding& row : encodings()) coded.insert(row.operation);
  EXPECT_EQ(coded.size(), operations().size());
}

TEST(Operations, NumbersFollowTheTable) {
  EXPECT_EQ(info(Operation::AND).de, "U");
  EXPECT_EQ(info(Operation::LOOP).id, "LOOP");
  EXPECT_EQ(info(Operation::MCRD).en, "MCRD");
}

TEST(Operations, FindsEveryMnemonicInBothLanguages) {
  for (const OperationInfo& row : operations()) {
    const auto german = findOperation(row.de, Mnemonics::German);
    const auto international = findOperation(row.en, Mnemonics::International);
    ASSERT_TRUE(german) << row.de;
    ASSERT_TRUE(international) << row.en;
    EXPECT_EQ(info(*german).de, row.de);
    EXPECT_EQ(info(*international).en, row.en);
  }
}

// S7-MNE: the same letters mean different timers in the two languages.
TEST(Operations, LanguageDecidesWhereWordsDiffer) {
  EXPECT_EQ(findOperation("SE", Mnemonics::German), Operation::TIMER_SE);
  EXPECT_EQ(findOperation("SE", Mnemonics::International), Operation::TIMER_SV);
  EXPECT_EQ(findOperation("UD", Mnemonics::German), Operation::AND_D);
  EXPECT_EQ(findOperation("SPB", Mnemonics::German), Operation::SPB);
  EXPECT_EQ(findOperation("JC", Mnemonics::International), Operation::SPB);
}

TEST(Operations, UnknownWordsAreNotFound) {
  EXPECT_FALSE(findOperation("JC", Mnemonics::German));
  EXPECT_FALSE(findOperation("U", Mnemonics::International));
  EXPECT_FALSE(findOperation("", Mnemonics::German));
  EXPECT_FALSE(findOperation("spb", Mnemonics::German));
  EXPECT_FALSE(findOperation("CALL", Mnemonics::German));
}

// The first of several operations with one mnemonic is the one with an operand.
TEST(Operations, AmbiguousWordsGiveTheFirstRow) {
  EXPECT_EQ(findOperation("O", Mnemonics::German), Operation::OR);
  EXPECT_EQ(findOperation("L", Mnemonics::German), Operation::LOAD);
  EXPECT_EQ(findOperation("T", Mnemonics::International), Operation::TRANSFER);
}

}  // namespace
}  // namespace merker::mc7
