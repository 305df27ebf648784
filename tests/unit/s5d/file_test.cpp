// The directories of an S5D file.
#include "program.h"
#include "s5d/layout.h"

namespace merker::s5d {
namespace {

const std::string kText =
    "OB 1\n SPA PB 5\n BE\nPB 5\n U E 1.0\n = A 1.0 ! Lampe\n BE\nDB 10\n 0: KF +5\n";

std::string namesOf(const std::vector<Record>& records) {
  std::string text;
  for (const Record& record : records) text += record.name() + " ";
  return text;
}

TEST(File, HasWholeRecordsADirectoryAndSortedBlocks) {
  const auto bytes = fileOf(kText);
  ASSERT_EQ(bytes.size() % kRecord, 0u);
  EXPECT_EQ(littleAt(bytes, kSize) * kRecord, bytes.size());
  EXPECT_TRUE(isS5d(bytes));
  const File file = readFile(bytes);
  EXPECT_EQ(file.name, "TEST");
  EXPECT_EQ(namesOf(file.records), "OB 1 PB 5 PK 5 DV 10 DB 10 ");
  EXPECT_TRUE(file.deleted.empty());
  for (const Record& record : file.records) EXPECT_EQ(record.offset % kRecord, 0u);
}

TEST(File, TextIsNone) {
  const std::string text(4096, 'p');
  EXPECT_FALSE(isS5d({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
  EXPECT_FALSE(isS5d({}));
  EXPECT_FALSE(isS5d(std::vector<std::uint8_t>(4096, 0)));
}

// The last block of the only section is no longer in its directory.
std::vector<std::uint8_t> withoutLast(std::vector<std::uint8_t> bytes) {
  const std::size_t section = littleAt(bytes, kDirectory + kSectionRecord) * kRecord;
  --bytes[section + kCount];
  return bytes;
}

TEST(File, ADeletedBlockIsKeptApart) {
  const Contents contents = readProgram(withoutLast(fileOf(kText)), Encoding::Cp437);
  EXPECT_EQ(contents.program.size(), 2u);
  ASSERT_EQ(contents.deleted.size(), 1u);
  EXPECT_EQ(contents.deleted.begin()->first, (mc5::BlockId{mc5::BlockType::Db, 10}));
  EXPECT_TRUE(contents.notes.empty());
}

TEST(File, WithoutADirectoryTheBlocksAreFoundByTheirMarks) {
  auto bytes = fileOf(kText);
  bytes[kCount] = 0;
  EXPECT_TRUE(isS5d(bytes));
  const Contents contents = readProgram(bytes, Encoding::Cp437);
  EXPECT_EQ(contents.program.size(), 3u);
  EXPECT_EQ(contents.program.at({mc5::BlockType::Pb, 5}).comments.size(), 1u);
  EXPECT_EQ(contents.program.at({mc5::BlockType::Db, 10}).formats[0], mc5::Format::Fixed);
  ASSERT_EQ(contents.notes.size(), 1u);
  EXPECT_NE(contents.notes[0].text.find("directory"), std::string::npos);
}

}  // namespace
}  // namespace merker::s5d
