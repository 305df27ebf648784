#include "archive/tree.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "../archive_zip.h"

namespace merker::archive {
namespace {

std::string textOf(const Tree& tree, const std::string& path) {
  const auto file = tree.open(path);
  return file ? file->text(1000) : "(none)";
}

bool refused(const Tree& tree, Refusal why) {
  for (const Refused& r : tree.refused())
    if (r.why == why) return true;
  return false;
}

TEST(Tree, namesOfAFolderAreComparedWithoutCase) {
  const TestFolder folder;
  folder.write("YDBs/27/SYMLIST.DBF", "symbols");
  folder.write("a.txt", "a");
  const Tree tree(folder.path());
  ASSERT_TRUE(tree.readable());
  EXPECT_EQ(tree.files().size(), 2u);
  EXPECT_EQ(textOf(tree, "ydbs/27/symlist.dbf"), "symbols");
  EXPECT_EQ(tree.below("YDBS").size(), 1u);
  EXPECT_EQ(tree.find("ydbs/28/symlist.dbf"), nullptr);
}

TEST(Tree, aZipIsATreeAndAZipInAFolderAFolderOfIt) {
  const TestFolder folder;
  folder.zip("p.zip", {{"P/hrs/S7RESOFF.DBF", "programs"}, {"P\\x.txt", "x"}});
  EXPECT_EQ(textOf(Tree(folder.path("p.zip")), "p/HRS/s7resoff.dbf"), "programs");
  const Tree above(folder.path());
  EXPECT_EQ(textOf(above, "p.zip/P/hrs/S7RESOFF.DBF"), "programs");
  EXPECT_EQ(textOf(above, "p.zip/P/x.txt"), "x");
}

TEST(Tree, aZipInAZipIsReadToADepth) {
  const TestFolder folder;
  folder.zip("1.zip", {{"a.txt", "inside"}});
  std::string bytes = folder.read("1.zip");
  for (const char* name : {"2.zip", "3.zip", "4.zip"}) {
    folder.zip(name, {{"n.zip", bytes}});
    bytes = folder.read(name);
  }
  EXPECT_EQ(textOf(Tree(folder.path("2.zip")), "n.zip/a.txt"), "inside");
  const Tree deep(folder.path("4.zip"));
  EXPECT_EQ(deep.files().size(), 0u);
  EXPECT_TRUE(refused(deep, Refusal::TooDeep));
}

TEST(Tree, pathsThatLeadOutAndLinksAreRefused) {
  const TestFolder folder;
  folder.zip(
      "p.zip",
      {{"../evil", "x"}, {"/etc/evil", "x"}, {"C:/evil", "x"}, {"a/../../b", "x"}, {"good", "y"}});
  const Tree tree(folder.path("p.zip"));
  ASSERT_EQ(tree.files().size(), 1u);
  EXPECT_EQ(tree.files()[0].path, "good");
  EXPECT_EQ(tree.refused().size(), 4u);
  EXPECT_TRUE(refused(tree, Refusal::LeadsOut));
  folder.write("d/real", "z");
  std::filesystem::create_symlink("/etc/passwd", folder.path("d/link"));
  const Tree disk(folder.path("d"));
  EXPECT_EQ(disk.files().size(), 1u);
  EXPECT_TRUE(refused(disk, Refusal::Link));
}

// What comes out counts, not what the directory of the zip says.
TEST(Tree, aBombIsNotUnpacked) {
  const TestFolder folder;
  folder.zip("p.zip", {{"big", std::string(3'000'000, ' ')}, {"small", "s"}});
  Limits limits;
  limits.unpacked = 2'000'000;
  const Tree large(folder.path("p.zip"), limits);
  EXPECT_EQ(large.open("big"), nullptr);
  EXPECT_TRUE(refused(large, Refusal::TooLarge));
  EXPECT_EQ(textOf(large, "small"), "s");
  Limits thin;
  thin.dense = 1'000'000;
  const Tree dense(folder.path("p.zip"), thin);
  EXPECT_EQ(dense.open("big"), nullptr);
  EXPECT_TRUE(refused(dense, Refusal::TooDense));
  EXPECT_EQ(textOf(dense, "small"), "s");
  const auto whole = Tree(folder.path("p.zip")).open("big");
  ASSERT_NE(whole, nullptr);
  EXPECT_EQ(whole->size(), 3'000'000u);
}

// The record of a file in the directory at the end of a zip.
std::size_t recordOf(const std::string& zip, const std::string& name) {
  return zip.find(name, zip.find("PK\1\2")) - 46;
}

// 62 kB may say ten thousand times that a file of a megabyte lies at one place.
TEST(Tree, filesThatShareTheirBytesAreABombAsWell) {
  const TestFolder folder;
  std::map<std::string, std::string> files{{"f0", std::string(900'000, ' ')}};
  for (int i = 1; i < 10; ++i) files["f" + std::to_string(i)] = "";
  folder.zip("p.zip", files);
  std::string bytes = folder.read("p.zip");
  const std::size_t first = recordOf(bytes, "f0");
  for (int i = 1; i < 10; ++i) {
    const std::size_t record = recordOf(bytes, "f" + std::to_string(i));
    bytes.replace(record + 6, 22, bytes, first + 6, 22);  // method, sum, sizes
    bytes.replace(record + 42, 4, bytes, first + 42, 4);  // where it lies
  }
  folder.write("p.zip", bytes);
  Limits limits;
  limits.dense = 1'000'000;
  const Tree tree(folder.path("p.zip"), limits);
  for (int again = 0; again < 5; ++again) EXPECT_NE(tree.open("f0"), nullptr);
  EXPECT_TRUE(tree.refused().empty());
  EXPECT_EQ(tree.open("f1"), nullptr);
  EXPECT_TRUE(refused(tree, Refusal::TooDense));
  // Zips in it share what the outer one may give.
  folder.zip("outer.zip", {{"1.zip", folder.read("p.zip")}, {"2.zip", folder.read("p.zip")}});
  const Tree outer(folder.path("outer.zip"), limits);
  EXPECT_NE(outer.open("1.zip/f0"), nullptr);
  EXPECT_EQ(outer.open("2.zip/f0"), nullptr);
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
    text.replace(at, what.size(), with);
  return text;
}

TEST(Tree, aNameWithControlCharactersCostsItself) {
  const TestFolder folder;
  folder.zip("p.zip", {{"a~.txt", "a"}, {"\u00fc~.txt", "u"}, {"good", "g"}});
  for (const char* control : {"\x1B", "\n", "\x7F"}) {
    folder.write("q.zip", replaced(folder.read("p.zip"), "~", control));
    const Tree tree(folder.path("q.zip"));
    EXPECT_EQ(tree.files().size(), 1u);
    EXPECT_EQ(textOf(tree, "good"), "g");
    ASSERT_EQ(tree.refused().size(), 2u);
    EXPECT_EQ(tree.refused()[0].path, std::string("a") + control + ".txt");
    EXPECT_EQ(tree.refused()[1].why, Refusal::BadName);
  }
  folder.write("d/new\nline.txt", "x");
  EXPECT_TRUE(refused(Tree(folder.path("d")), Refusal::BadName));
}

// libzip itself refuses the whole zip.
TEST(Tree, aNameThatIsNotTheUtf8ThatItSaysCostsItself) {
  const TestFolder folder;
  folder.zip("p.zip", {{"\u00fc~.txt", "u"}, {"\u00f6.txt", "o"}, {"good", "g"}});
  folder.write("q.zip", replaced(folder.read("p.zip"), "~", "\xFF"));
  const Tree tree(folder.path("q.zip"));
  EXPECT_EQ(tree.files().size(), 2u);
  EXPECT_EQ(textOf(tree, "\u00f6.txt"), "o");
  ASSERT_EQ(tree.refused().size(), 1u);
  EXPECT_EQ(tree.refused()[0].why, Refusal::BadName);
  EXPECT_EQ(tree.refused()[0].path, "\u00fc\xFF.txt");
  // Without the flag a name that is not UTF-8 is in the code page of DOS.
  folder.zip("dos.zip", {{"gr~n.txt", "g"}});
  folder.write("dos.zip", replaced(folder.read("dos.zip"), "~", "\x81"));
  EXPECT_EQ(textOf(Tree(folder.path("dos.zip")), "gr\u00fcn.txt"), "g");
}

TEST(Tree, theNumberOfFilesIsLimited) {
  const TestFolder folder;
  std::map<std::string, std::string> files;
  for (int i = 0; i < 20; ++i) files["f" + std::to_string(i)] = "x";
  folder.zip("p.zip", files);
  Limits limits;
  limits.entries = 10;
  const Tree tree(folder.path("p.zip"), limits);
  EXPECT_EQ(tree.files().size(), 10u);
  EXPECT_TRUE(refused(tree, Refusal::TooMany));
}

TEST(Tree, aDamagedZipCostsItself) {
  const TestFolder folder;
  folder.zip("p.zip", {{"a", std::string(5000, 'a') + "b"}});
  std::string bytes = folder.read("p.zip");
  folder.write("cut.zip", bytes.substr(0, 40));
  const Tree cut(folder.path("cut.zip"));
  EXPECT_TRUE(cut.isSingleFile());
  bytes[45] = static_cast<char>(bytes[45] ^ 0x55);  // inside the packed data
  folder.write("wrong.zip", bytes);
  const Tree wrong(folder.path("wrong.zip"));
  ASSERT_EQ(wrong.files().size(), 1u);
  EXPECT_EQ(wrong.open("a"), nullptr);
  EXPECT_TRUE(refused(wrong, Refusal::Unreadable));
  EXPECT_FALSE(Tree(folder.path("missing")).readable());
}

// Files have headers of their own: those before the damage are read without the directory.
TEST(Tree, aZipThatIsCutOffGivesItsWholeFiles) {
  const TestFolder folder;
  folder.zip("p.zip", {{"a.txt", "first"}, {"b/c.txt", std::string(5000, 'x')}, {"d.txt", "last"}});
  const std::string whole = folder.read("p.zip");
  const std::size_t third = whole.find("PK\3\4", whole.find("b/c.txt"));
  folder.write("cut.zip", whole.substr(0, third + 20));
  const Tree tree(folder.path("cut.zip"));
  EXPECT_EQ(tree.files().size(), 2u);
  EXPECT_EQ(textOf(tree, "a.txt"), "first");
  EXPECT_EQ(textOf(tree, "B/C.TXT"), std::string(1000, 'x'));
  ASSERT_EQ(tree.refused().size(), 1u);
  EXPECT_EQ(tree.refused()[0].why, Refusal::Damaged);
  EXPECT_EQ(tree.refused()[0].path, fmt::format("cut.zip, from byte {} on", third));
}

TEST(Tree, aZipOfHeadersOnlyIsDamaged) {
  const TestFolder folder;
  std::string bytes;
  for (int i = 0; i < 20'000; ++i)
    bytes += std::string("PK\3\4\x14\0\x08\0", 8) + std::string(26, '\0');
  folder.write("h.zip", bytes);
  const Tree tree(folder.path("h.zip"));
  EXPECT_TRUE(refused(tree, Refusal::Damaged));
}

}  // namespace
}  // namespace merker::archive
