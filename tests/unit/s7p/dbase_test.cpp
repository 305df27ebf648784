#include "s7p/dbase.h"

#include <gtest/gtest.h>

#include "../s7p_files.h"
#include "base/code_page.h"

namespace merker::s7p {
namespace {

std::unique_ptr<archive::File> file(const std::string& bytes) {
  return archive::fileOf({bytes.begin(), bytes.end()});
}

const std::vector<s7p_files::Column> kColumns{{"NAME", 'C', 8}, {"ID", 'N', 5}};

// S7P section 4
TEST(Table, rowsColumnsAndDeletedRows) {
  Table table(file(s7p_files::table(kColumns,
                                    {{{"NAME", "one"}, {"ID", "1"}},
                                     {{"NAME", "gone"}, {"ID", "x"}},
                                     {{"NAME", "two"}, {"ID", "22"}}},
                                    false, {1})));
  ASSERT_TRUE(table.next());
  EXPECT_EQ(table.text("NAME"), "one");
  EXPECT_EQ(table.number("ID"), 1u);
  EXPECT_EQ(table.bytes("MISSING"), "");
  ASSERT_TRUE(table.next());
  EXPECT_EQ(table.number("ID"), 22u);
  EXPECT_FALSE(table.next());
}

TEST(Table, aShortLastRowEndsTheTable) {
  const std::string bytes =
      s7p_files::table(kColumns, {{{"NAME", "one"}}, {{"NAME", "two"}}, {{"NAME", "three"}}});
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    Table table(file(bytes.substr(0, length)));
    int rows = 0;
    while (table.next()) ++rows;
    EXPECT_LE(rows, 3);
    if (table.good()) {
      EXPECT_EQ(table.missingRows(), 3u - static_cast<unsigned>(rows)) << length;
    }
    if (length > bytes.size() - 10) EXPECT_EQ(rows, length + 2 > bytes.size() ? 3 : 2);
  }
}

TEST(Table, manyRowsComeInPieces) {
  std::vector<s7p_files::Row> rows;
  for (int i = 0; i < 20'000; ++i) rows.push_back({{"ID", std::to_string(i)}});
  Table table(file(s7p_files::table(kColumns, rows)));
  for (std::uint32_t i = 0; i < 20'000; ++i) {
    ASSERT_TRUE(table.next());
    ASSERT_EQ(table.number("ID"), i);
  }
  EXPECT_FALSE(table.next());
}

TEST(Memo, contentsAreCutToTheirLength) {
  s7p_files::Memo written;
  const std::string first = written.add("abc"), second = written.add(std::string(2000, 'x'));
  const Memo memo(file(written.bytes()));
  EXPECT_EQ(memo.read(1, 100)->size(), 3u);
  EXPECT_EQ(memo.read(static_cast<std::uint32_t>(std::stoul(second)), 5000)->size(), 2000u);
  EXPECT_EQ(memo.read(static_cast<std::uint32_t>(std::stoul(second)), 7)->size(), 7u);
  EXPECT_FALSE(memo.read(0, 10));
  EXPECT_FALSE(memo.read(99, 10));
  const Memo cut(file(written.bytes().substr(0, 1500)));
  EXPECT_FALSE(cut.read(static_cast<std::uint32_t>(std::stoul(second)), 5000));
}

TEST(CodePage, umlautsCyrillicAndChinese) {
  EXPECT_EQ(CodePage(1252).toUtf8("F\xFCllstand \x80"), "Füllstand €");
  EXPECT_EQ(CodePage(1251).toUtf8("\xCD\xE0\xF1\xEE\xF1"), "Насос");
  EXPECT_EQ(CodePage(1250).toUtf8("\xE8"), "č");
  EXPECT_EQ(CodePage(936).toUtf8("\xB1\xC3 1"), "泵 1");
  EXPECT_TRUE(CodePage(936).isWide());
  EXPECT_EQ(CodePage(850).toUtf8("\x81"), "ü");
  EXPECT_EQ(CodePage(99999).number(), 1252u);
  EXPECT_EQ(CodePage(1252).toUtf8("\x81"), "\uFFFD");
}

}  // namespace
}  // namespace merker::s7p
