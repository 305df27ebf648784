#include "archive/zip_writer.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "../archive_zip.h"
#include "archive/tree.h"

namespace merker::archive {
namespace {

constexpr std::int64_t kMorning = 1'700'000'000;  // 2023-11-14 22:13:20 UTC
constexpr std::uint64_t kMost = 1 << 20;

Packed packed(const std::string& path, const std::string& text, std::int64_t changed = kMorning) {
  return {path, text.size(), changed, [text] { return fileOf({text.begin(), text.end()}); }};
}

std::string bytesOf(const Zipped& zip) { return zip.file ? zip.file->text(kMost) : ""; }

TEST(ZipWriter, whatIsWrittenIsRead) {
  const std::string large(200'000, 'm');
  Zipped zip = writeZip(
      {packed("merker.toml", "[cpu]\n"), packed("lib/größe.awl", large), packed("empty.awl", "")},
      kMost, {});
  ASSERT_EQ(zip.failure, ZipFailure::None);
  const Tree tree(std::move(zip.file));
  ASSERT_EQ(tree.files().size(), 3u);
  EXPECT_EQ(tree.open("merker.toml")->text(100), "[cpu]\n");
  EXPECT_EQ(tree.open("lib/größe.awl")->text(kMost), large);
  EXPECT_EQ(tree.open("empty.awl")->size(), 0u);
  EXPECT_TRUE(tree.refused().empty());
}

// Another program reads it, with the time of the file and its rights, and finds no fault.
TEST(ZipWriter, otherProgramsReadIt) {
  const TestFolder folder;
  const Zipped zip = writeZip({packed("a/b.awl", "U E 0.0;\n"), packed("old", "x", 0)}, kMost, {});
  folder.write("p.zip", bytesOf(zip));
  folder.write("read.py",
               "import sys, zipfile\n"
               "z = zipfile.ZipFile(sys.argv[1])\n"
               "assert z.testzip() is None\n"
               "assert z.namelist() == ['a/b.awl', 'old'], z.namelist()\n"
               "assert z.read('a/b.awl') == b'U E 0.0;\\n'\n"
               "one, old = z.infolist()\n"
               "assert one.date_time == (2023, 11, 14, 22, 13, 20), one.date_time\n"
               "assert old.date_time == (1980, 1, 1, 0, 0, 0), old.date_time\n"
               "assert one.external_attr >> 16 == 0o100644, oct(one.external_attr)\n");
  const std::string command = "python3 " + folder.path("read.py") + " " + folder.path("p.zip");
  EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST(ZipWriter, sameFilesGiveTheSameBytes) {
  const std::vector<Packed> files{packed("a", "1"), packed("b", "2")};
  const std::string first = bytesOf(writeZip(files, kMost, {}));
  ::setenv("TZ", "Asia/Tokyo", 1);
  ::tzset();
  EXPECT_EQ(bytesOf(writeZip(files, kMost, {})), first);
  ::unsetenv("TZ");
  ::tzset();
  EXPECT_FALSE(first.empty());
}

// What is read counts, not what somebody said of its length.
TEST(ZipWriter, thereIsALimit) {
  Packed liar = packed("long", std::string(2000, 'x'));
  liar.size = 1;
  const std::vector<Packed> files{packed("short", "x"), liar};
  EXPECT_EQ(writeZip(files, 2001, {}).failure, ZipFailure::None);
  const Zipped none = writeZip(files, 2000, {});
  EXPECT_EQ(none.failure, ZipFailure::TooLarge);
  EXPECT_EQ(none.file, nullptr);
}

TEST(ZipWriter, aFileThatCannotBeReadIsNamed) {
  const Zipped none = writeZip(
      {packed("a", "1"), {"gone", 1, 0, [] { return std::unique_ptr<File>(); }}}, kMost, {});
  EXPECT_EQ(none.failure, ZipFailure::Unreadable);
  EXPECT_EQ(none.path, "gone");
}

TEST(ZipWriter, canBeStopped) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(writeZip({packed("a", "1")}, kMost, stop.get_token()).failure, ZipFailure::Stopped);
}

}  // namespace
}  // namespace merker::archive
