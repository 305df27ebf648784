// What a user types as an operand gets the spelling of texts.
#include <gtest/gtest.h>

#include "networks/source_edit.h"

namespace merker::networks {
namespace {

// The second line of the network, in which the operand of a contact was typed.
std::string lineWith(const std::string& typed, const std::string& head, const Surroundings& around,
                     const std::string& statement = "U E 0.0") {
  const source::SourceFile file("typed", head + statement + "\n");
  const auto block = blockAt(file, 1, around);
  graph::Edit edit;
  edit.action = graph::Action::SetOperand;
  edit.at = {static_cast<int>(block->networks[0].source.statements.size()) - 1, graph::kOwn};
  if (statement.starts_with("L")) edit.at.pin = graph::kFirstPin;
  edit.operands.emplace_back().text = typed;
  const auto done = networks::edit(file, 1, 1, edit, around);
  if (!done) return std::string(text(done.error(), graph::Language::English));
  return done->lines.empty() ? "unchanged" : done->lines.front();
}

struct Spelling {
  std::string typed, text;
};

const std::string kHead =
    "FUNCTION FC 1 : VOID\nVAR_TEMP\n  Ready : BOOL;\n  Both : BOOL;\n  Part : STRUCT\n    on : "
    "BOOL;\n"
    "  END_STRUCT;\nEND_VAR\nBEGIN\nNETWORK\n";

source::SymbolTable symbolsOf(source::Language language) {
  source::SymbolTable symbols(language);
  for (const auto& [name, address] : {std::pair{"Motor", "A 4.0"}, std::pair{"Both", "A 4.1"}})
    symbols.add({name, *source::parseSymbolAddress(address, {}, language), {}, {}, {}, {}});
  return symbols;
}

// S7-SYM-06
TEST(Spelling, IsThatOfTheText) {
  const auto symbols = symbolsOf(source::Language::Step7);
  const Surroundings around{source::Language::Step7, &symbols, nullptr, nullptr, {}};
  for (const Spelling& row : std::vector<Spelling>{{"E0.1", "E 0.1"},
                                                   {"m10.1", "M 10.1"},
                                                   {" E  1.2 ", "E 1.2"},
                                                   {"t5", "T 5"},
                                                   {"DB5.DBX2.0", "DB5.DBX 2.0"},
                                                   {"Ready", "#Ready"},
                                                   {"#Ready", "#Ready"},
                                                   {"Part.on", "#Part.on"},
                                                   {"Motor", "\"Motor\""},
                                                   {"\"Motor\"", "\"Motor\""},
                                                   {"Both", "#Both"},
                                                   {"\"Both\"", "\"Both\""},
                                                   {"nobody", "nobody"}})
    EXPECT_EQ(lineWith(row.typed, kHead, around), "U " + row.text) << row.typed;
  for (const Spelling& row : std::vector<Spelling>{{"mw10", "MW 10"},
                                                   {"pew256", "PEW 256"},
                                                   {"-5", "-5"},
                                                   {"S5T#2s", "S5T#2s"},
                                                   {"db1.dbw2", "DB1.DBW 2"}})
    EXPECT_EQ(
        lineWith(row.typed, kHead, around, "L MW 1; T MW 2; NOP 0").substr(0, 2 + row.text.size()),
        "L " + row.text)
        << row.typed;
}

TEST(Spelling, HasTheMnemonicsOfTheText) {
  const Surroundings around{source::Language::Step7, nullptr, nullptr, nullptr,
                            Mnemonics::International};
  EXPECT_EQ(lineWith("E0.1", kHead, around, "A I 0.0"), "A I 0.1");
  EXPECT_EQ(lineWith("q0.1", kHead, around, "A I 0.0"), "A Q 0.1");
}

TEST(Spelling, OfStep5) {
  const auto symbols = symbolsOf(source::Language::Step5);
  const Surroundings around{source::Language::Step5, &symbols, nullptr, nullptr, {}};
  for (const Spelling& row : std::vector<Spelling>{
           {"e0.1", "E 0.1"}, {"M10.1", "M 10.1"}, {"T5", "T 5"}, {"Motor", "-Motor"}})
    EXPECT_EQ(lineWith(row.typed, "PB 1\n", around), "U " + row.text) << row.typed;
}

}  // namespace
}  // namespace merker::networks
