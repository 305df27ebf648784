// The directories of an S5D file.
#include <algorithm>

#include "program.h"
#include "s5d/bytes.h"
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

std::string manyBlocks() {
  std::string text = kText;
  for (int i = 10; i < 180; ++i) text += "PB " + std::to_string(i) + "\n U E 1.0 ! x\n BE\n";
  return text;
}

// Only the blocks behind it count: as many of a file of a few records as of one in which the
// damage makes entries that lead into it (0101h is record 257).
TEST(File, ADamagedFirstRecordCostsNoBlock) {
  for (const std::string& text : {kText, manyBlocks()})
    for (const std::size_t length : {std::size_t{16}, std::size_t{kRecord}})
      for (const int fill : {0xFF, 0x00, 0x01, 0x20}) {
        auto bytes = fileOf(text);
        std::fill_n(bytes.begin(), length, static_cast<std::uint8_t>(fill));
        EXPECT_TRUE(isS5d(bytes)) << length << " bytes " << fill;
        const Contents contents = readProgram(bytes, Encoding::Cp437);
        const mc5::Program wanted = programOf(text);
        ASSERT_EQ(contents.program.size(), wanted.size()) << length << " bytes " << fill;
        for (const auto& [id, block] : wanted)
          EXPECT_EQ(contents.program.at(id).words, block.words);
        EXPECT_TRUE(contents.deleted.empty());
        EXPECT_EQ(contents.notes.size(), length == kRecord ? 1u : 0u);
        EXPECT_EQ(contents.program.at({mc5::BlockType::Pb, 5}).comments.size(), 1u);
      }
}

// What only looks like a pre-header makes no program of a file.
TEST(File, OneWithoutABlockOfCodeOrDataIsNone) {
  std::vector<std::uint8_t> bytes(4 * kRecord, ' ');
  bytes[kRecord] = 0x0A;
  setWord(bytes, kRecord + kPreLength, 64);
  EXPECT_FALSE(isS5d(bytes));
}

}  // namespace
}  // namespace merker::s5d
