// Damaged S5D files: what is damaged costs itself.
#include <random>

#include "program.h"
#include "s5d/layout.h"

namespace merker::s5d {
namespace {

const std::string kFourBlocks =
    "OB 1\nNETZWERK 1 A\n SPA FB 5\nNAME : V\nX : E 1.0\n BE ! e\nPB 5\n U E 1.0\n BE\nFB 5 V\n"
    "BEZ : X E BI\nM1 : U =X\n SPB =M1\n BE\nDB 10\n 0: KF +5\n 1: KS 'HALLO'\n";

std::string notesOf(const Contents& contents) {
  std::string text;
  for (const Note& note : contents.notes) text += note.block + ": " + note.text + "\n";
  return text;
}

std::size_t offsetOf(const std::vector<std::uint8_t>& bytes, const std::string& name) {
  for (const Record& record : readFile(bytes).records)
    if (record.name() == name) return record.offset;
  ADD_FAILURE() << name;
  return 0;
}

TEST(Damage, ABlockWithoutItsEndCostsItself) {
  auto bytes = fileOf(kFourBlocks);
  const std::size_t at = offsetOf(bytes, "PB 5");
  bytes[at + 12] = 0;  // BE
  const Contents contents = readProgram(bytes, Encoding::Cp437);
  EXPECT_EQ(contents.program.size(), 3u);
  EXPECT_EQ(notesOf(contents), "PB 5: it does not end with BE\n");
}

TEST(Damage, ADamagedParameterListCostsItsBlock) {
  auto bytes = fileOf(kFourBlocks);
  bytes[offsetOf(bytes, "FB 5") + 11] = 7;
  const Contents contents = readProgram(bytes, Encoding::Cp437);
  EXPECT_EQ(notesOf(contents), "FB 5: the list of its parameters is damaged\n");
  bytes = fileOf(kFourBlocks);
  bytes[offsetOf(bytes, "FB 5") + 20] = 9;
  EXPECT_EQ(notesOf(readProgram(bytes, Encoding::Cp437)),
            "FB 5: its parameter 'X' has the unknown kind 09 80\n");
}

TEST(Damage, AFileThatEndsEarlyCostsItsLastBlocks) {
  auto bytes = fileOf(kFourBlocks);
  bytes.resize(offsetOf(bytes, "DB 10") + 12);
  const Contents contents = readProgram(bytes, Encoding::Cp437);
  EXPECT_EQ(contents.program.size(), 3u);
  EXPECT_EQ(notesOf(contents), "DB 10: the file ends before it does\n");
}

TEST(Damage, DamagedFormatsBecomeKh) {
  auto bytes = fileOf(kFourBlocks);
  bytes[offsetOf(bytes, "DV 10") + 7] = 0xFF;
  const Contents contents = readProgram(bytes, Encoding::Cp437);
  EXPECT_EQ(contents.program.at({mc5::BlockType::Db, 10}).formats[0], mc5::Format::Hex);
  EXPECT_NE(notesOf(contents).find("DV 10"), std::string::npos);
}

TEST(Damage, LabelsOfAnotherFormAreMadeAnew) {
  auto bytes = fileOf(kFourBlocks);
  bytes[offsetOf(bytes, "FV 5") + 10] = '?';
  const Contents contents = readProgram(bytes, Encoding::Cp437);
  EXPECT_TRUE(contents.program.at({mc5::BlockType::Fb, 5}).labels.empty());
  EXPECT_NE(step5::listing(contents.program).find("SPB   =M001"), std::string::npos);
}

TEST(Damage, BlocksOfOtherPlcsAreNamed) {
  auto bytes = fileOf(kFourBlocks);
  bytes[offsetOf(bytes, "DB 10") + 2] = 0x0C;
  EXPECT_EQ(notesOf(readProgram(bytes, Encoding::Cp437)),
            "DX 10: SINUMERIK 810/820 has no such block\n");
  bytes = fileOf(kFourBlocks);
  bytes[offsetOf(bytes, "OB 1") + 3] = 200;
  EXPECT_EQ(readProgram(bytes, Encoding::Cp437).program.size(), 3u);
}

// Whatever bytes: no crash, and what comes is a program that can be printed and written again.
TEST(Damage, AnyBytesAreTaken) {
  std::mt19937 random(20260101);
  const auto whole = fileOf(kFourBlocks);
  for (int round = 0; round < 3000; ++round) {
    auto bytes = whole;
    for (int i = 0; i < 6; ++i)
      bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    if (round % 3 == 0) bytes.resize(random() % bytes.size());
    const Contents contents = readProgram(bytes, Encoding::Cp850);
    const std::string text = step5::listing(contents.program);
    const Contents again =
        readProgram(writeProgram(contents.program, "X", Encoding::Cp850), Encoding::Cp850);
    ASSERT_EQ(again.program.size(), contents.program.size()) << round;
    for (const auto& [id, block] : contents.program)
      ASSERT_EQ(again.program.at(id).words, block.words) << round << text;
  }
}

}  // namespace
}  // namespace merker::s5d
