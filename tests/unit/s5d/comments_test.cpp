// Comment blocks: titles, comments of statements, parameters and data words.
#include "s5d/comments.h"

#include <algorithm>

#include "program.h"

namespace merker::s5d {
namespace {

TEST(Comments, StandWhereTheyStood) {
  const std::string text =
      "OB 1\nNETZWERK 1 Einschalten\n     : U     E 1.0               ! Taster\n"
      "! vor dem Ausgang\n! noch eine\n     : =     A 1.0\n"
      "     : SPA   FB 5\nNAME : VENTIL\nAUF  : E 2.0                 ! Endlage\nZAHL : KF +25\n"
      "NETZWERK 2 Ende\n     : SPB   PB 9                ! Schluss\n     : BE                      "
      " "
      " ! aus\n\nPB 9\n     : BE\n\nFB 5   VENTIL\n"
      "BEZ  : AUF   E/A/D/B/T/Z: E  BI/BY/W/D: BI\n"
      "BEZ  : ZAHL  E/A/D/B/T/Z: D  KM/KH/KY/KC/KT/KZ/KF/KG: KF\nM1   : U     =AUF\n"
      "     : SPB   =M1                 ! Sprung\n     : BE\n\nDB 3\n! Titel\n"
      "    0: KH 0001                  ! erstes\n    1: KG +1000000+01            ! Zahl\n"
      "    3: KF +5                    ! letztes\n\n";
  const mc5::Program once = programOf(text);
  EXPECT_EQ(cameBack(text), step5::listing(once));
}

TEST(Comments, HaveTheNumbersOfSTEP5) {
  const mc5::Program program = programOf(
      "PB 1\nNETZWERK 1 A\n U E 1.0 ! eins\n SPA FB 5\nNAME : V\nX : E 1.1 ! vier\n U M 1.0 ! f\n"
      "NETZWERK 2 B\n BE ! b\nFB 5 V\nBEZ : X E BI\n BE\n");
  const auto bytes = writeComments(program, program.at({mc5::BlockType::Pb, 1}), Encoding::Cp437);
  ASSERT_GT(bytes.size(), 26u);
  EXPECT_EQ(bytes[2], 0x31);  // PK
  const std::string entries(bytes.begin() + 26, bytes.end());
  EXPECT_EQ(entries, std::string("\x01\x00\x01"
                                 "A\x01\x80\x04"
                                 "eins\x04\x80\x04"
                                 "vier\x05\x80\x01"
                                 "f\x02\x00\x01"
                                 "B\x01\x80\x01"
                                 "b",
                                 30));
}

TEST(Comments, AreInTheCodePageOfDos) {
  const std::string text = "PB 1\nNETZWERK 1 Größe µm\n     : BE                        ! Ä\n\n";
  const std::string was = step5::listing(programOf(text));
  EXPECT_NE(was.find("Größe µm"), std::string::npos);
  EXPECT_EQ(cameBack(text), was);
  EXPECT_EQ(cameBack(text, Encoding::Cp850), was);
  const auto file = fileOf(text);
  EXPECT_NE(std::ranges::find(file, 0x94), file.end());  // ö
  EXPECT_TRUE(readProgram(file, Encoding::Cp437).beyondAscii);
  EXPECT_FALSE(readProgram(fileOf("PB 1\n BE ! a\n"), Encoding::Cp437).beyondAscii);
}

TEST(Comments, LongOnesComeBackWhole) {
  for (const std::size_t length : {126u, 127u, 128u, 254u, 300u}) {
    const std::string text = "PB 1\n! a\n BE ! " + std::string(length, 'x') + "\n";
    EXPECT_EQ(cameBack(text), step5::listing(programOf(text))) << length;
  }
}

TEST(Comments, ChecksStayChecks) {
  const std::string text = "PB 1\n     : U     E 1.0               //= VKE = 0\n     : BE\n\n";
  EXPECT_EQ(cameBack(text), step5::listing(programOf(text)));
  EXPECT_NE(cameBack(text).find("//= VKE = 0"), std::string::npos);
}

TEST(Comments, OfLinesThatAreNotThereAreCounted) {
  mc5::Program program = programOf("PB 1\n U E 1.0 ! a\n U E 1.1 ! b\n BE\n");
  mc5::Block& block = program.at({mc5::BlockType::Pb, 1});
  const auto bytes = writeComments(program, block, Encoding::Cp437);
  block.words = {0x6500};
  block.comments.clear();
  EXPECT_EQ(readComments(bytes, program, Encoding::Cp437, block), 1u);
  ASSERT_EQ(block.comments.size(), 1u);
  EXPECT_EQ(block.comments[0].text, "! a");
}

}  // namespace
}  // namespace merker::s5d
