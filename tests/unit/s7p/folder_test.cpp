#include "s7p/folder.h"

#include <gtest/gtest.h>

#include "../archive_zip.h"
#include "../s7p_files.h"
#include "step7/compiler.h"

namespace merker::s7p {
namespace {

block::Program compiled(const std::string& text) {
  return step7::compile({source::SourceFile("a.awl", text)}, {}).program;
}

const std::string kFunction =
    "FUNCTION FC 1 : INT\nTITLE = t\nVERSION : 1.2\nVAR_INPUT\nIN : INT;\nEND_VAR\n"
    "VAR_OUTPUT\nOUT : BOOL;\nEND_VAR\nBEGIN\nNETWORK\nL #IN;\nT #RET_VAL;\nNETWORK\nU E 0.0;\n= "
    "#OUT;\n"
    "END_FUNCTION\n";

// The folder as files in a temporary folder, read by the product.
struct Stored {
  explicit Stored(const s7p_files::BlockFolder& blocks, std::size_t memoBytes = ~std::size_t{0}) {
    folder.write("SUBBLK.DBF", blocks.dbf());
    folder.write("subblk.DBT", blocks.dbt().substr(0, memoBytes));
  }
  Folder read(Faults& faults, unsigned page = 1252) {
    tree = std::make_unique<archive::Tree>(folder.path());
    return Folder(*tree, "", CodePage(page), faults);
  }
  TestFolder folder;
  std::unique_ptr<archive::Tree> tree;
};

bool has(const Faults& faults, FaultKind kind) {
  for (const Fault& fault : faults)
    if (fault.kind == kind) return true;
  return false;
}

TEST(Folder, aBlockWithItsTexts) {
  const auto program = compiled(kFunction);
  const block::Block& fc = program.at({BlockKind::FC, 1});
  s7p_files::BlockFolder blocks;
  s7p_files::BlockFolder::Extra extra;
  extra.declaration = "VAR_INPUT\r\n  IN : INT ;\t//\xC2\xF5\xEE\xE4\r\nEND_VAR\r\n";
  extra.title = "\xCD\xE0\xF1\xEE\xF1";
  extra.comment = "two\nlines";
  extra.networks = {{"first", "c1", {{0, 0x80, "load"}, {1, 0x20, ""}, {0, 0x00, "own line"}}},
                    {"X", "", {}}};
  extra.language = 2;
  blocks.add(fc, extra);
  Stored stored(blocks);
  Faults faults;
  Folder folder = stored.read(faults, 1251);
  ASSERT_EQ(folder.blocks().size(), 1u);
  const auto read = folder.read({BlockKind::FC, 1});
  ASSERT_TRUE(read);
  EXPECT_EQ(read->block.code, fc.code);
  EXPECT_EQ(read->block.language, block::Language::Kop);
  EXPECT_EQ(read->block.attributes.version, 0x12);
  EXPECT_EQ(read->block.networks.size(), 2u);
  EXPECT_EQ(block::parameters(read->block).size(), 3u);
  EXPECT_EQ(read->declaration, "VAR_INPUT\r\n  IN : INT ;\t//Вход\r\nEND_VAR\r\n");
  EXPECT_EQ(read->comments.title, "Насос");
  EXPECT_EQ(read->comments.comment, "two\nlines");
  EXPECT_EQ(read->created, "1984-01-02 00:00:01.000");
  ASSERT_EQ(read->comments.networks.size(), 2u);
  EXPECT_EQ(read->comments.networks[0].comment, "c1");
  EXPECT_EQ(read->comments.networks[1].title, "X");
  const auto& statements = read->comments.networks[0].statements;
  ASSERT_EQ(statements.size(), 2u);
  EXPECT_EQ(statements[0].text, "load");
  EXPECT_FALSE(statements[0].ownLine);
  EXPECT_EQ(statements[1].line, 1u);
  EXPECT_TRUE(statements[1].ownLine);
  EXPECT_TRUE(faults.empty());
}

// S7P section 10: each of these was seen in real projects.
TEST(Folder, damagedPartsCostThemselves) {
  const auto program = compiled(kFunction);
  s7p_files::BlockFolder blocks;
  s7p_files::BlockFolder::Extra unlinked, wrong;
  unlinked.attribute = 0;
  wrong.wrongChecksum = true;
  block::Block other = program.at({BlockKind::FC, 1});
  blocks.add(other, unlinked);
  other.code = {0x65, 0x00};
  other.networks.clear();
  blocks.add(other);
  other.id.number = 2;
  blocks.add(other, wrong);
  Stored stored(blocks);
  Faults faults;
  Folder folder = stored.read(faults);
  EXPECT_EQ(folder.blocks().size(), 2u);
  EXPECT_TRUE(has(faults, FaultKind::TwiceInFolder));
  EXPECT_EQ(folder.read({BlockKind::FC, 1})->block.code.size(), 2u) << "the linked one";
  EXPECT_FALSE(has(faults, FaultKind::WrongChecksum));
  EXPECT_EQ(folder.read({BlockKind::FC, 2})->block.code.size(), 2u);
  EXPECT_TRUE(has(faults, FaultKind::WrongChecksum));
  EXPECT_FALSE(folder.read({BlockKind::FC, 3}));
}

TEST(Folder, aCutMemoGivesNamesAndNumbers) {
  const auto program = compiled(kFunction);
  s7p_files::BlockFolder blocks;
  blocks.add(program.at({BlockKind::FC, 1}));
  for (std::size_t length = 0; length < blocks.dbt().size(); length += 37) {
    Stored stored(blocks, length);
    Faults faults;
    Folder folder = stored.read(faults);
    const auto read = folder.read({BlockKind::FC, 1});
    ASSERT_TRUE(read) << length;
    if (length < 520) EXPECT_TRUE(read->block.code.empty());
    if (length < 22) EXPECT_TRUE(has(faults, FaultKind::NoMemo));
  }
}

TEST(Folder, protectionIsThePassword) {
  const auto program = compiled(kFunction);
  s7p_files::BlockFolder blocks;
  s7p_files::BlockFolder::Extra hidden;
  hidden.password = 3;
  blocks.add(program.at({BlockKind::FC, 1}), hidden);
  Stored stored(blocks);
  Faults faults;
  Folder folder = stored.read(faults);
  EXPECT_TRUE(folder.read({BlockKind::FC, 1})->block.attributes.knowHowProtect);
}

TEST(Folder, variableTables) {
  s7p_files::BlockFolder blocks;
  blocks.addText(27, 4,
                 std::string("1 2 0 2 1 10 0 20\0"
                             "2 3 88 0 0 0 0\0"
                             "4 1 10 7 0 0 0\0"
                             "\0"
                             "5 4 2 0 12 0 0\0"
                             "8 3 5 0 0 0 0\0"
                             "7 7 7 7 7\0",
                             17 + 1 + 15 + 15 + 1 + 15 + 14 + 10));
  Stored stored(blocks);
  Faults faults;
  const auto tables = stored.read(faults).variableTables();
  ASSERT_EQ(tables.size(), 1u);
  EXPECT_EQ(tables[0].operands, (std::vector<std::string>{"EW 88", "M 10.7", "DB12.DBD 2", "T 5"}));
  EXPECT_EQ(tables[0].unknown, 1u);
}

}  // namespace
}  // namespace merker::s7p
