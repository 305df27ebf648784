// A program printed and compiled again has the same words.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <sstream>

#include "compile.h"

namespace merker::step5 {
namespace {

const std::string kExamples = std::string(MERKER_SOURCE_DIR) + "/examples/step5";

std::string fileText(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

void expectBack(const Compilation& first) {
  const std::string text = listing(first.program);
  const auto second = compileText(text);
  ASSERT_TRUE(second.ok()) << source::format(second.problems.list().front(), nullptr) << text;
  ASSERT_EQ(second.program.size(), first.program.size());
  for (const auto& [id, block] : first.program)
    EXPECT_EQ(second.program.at(id).words, block.words) << text;
}

std::string codeOf(const Compilation& c, mc5::BlockId id) {
  std::string text;
  for (const mc5::Line& line : disassemble(c.program, c.program.at(id)))
    text += mc5::toString(line) + "\n";
  return text;
}

TEST(Listing, ComesBack) {
  const auto first = compileText(R"(FB 5
NAME : TEST
BEZ : EIN E BI
BEZ : WERT D KG
BEZ : ZEIT T
NETZWERK 1 Anfang
     : U =EIN
     : LD =WERT
     : SPB =WEIT
     : L KT 10.2
     : SE =ZEIT
WEIT : NOP 0
NETZWERK 2 Ende
     : SU D 5.3
     : BE
OB 1
     : SPA FB 5
EIN  : M 30.0
WERT : KG +1234567+02
ZEIT : T 4
     : SPB PB 3
     : BE
PB 3
     : BE
DB 10
 KH 1F00
 KF -5
 KG +1000000+01
 KC A!
 KC ';A'
 KC '; '
)");
  ASSERT_TRUE(first.ok());
  expectBack(first);
}

constexpr const char* kCalls = R"(OB 1
 : SPA FB 5
AUF  : E 2.0
ZAHL : KF +25
TEXT : KC AB
BYTE : KY 10,255
BILD : KM 00111110 01011011
ZEIT : KT 10.2
ZAEL : KZ 100
HEXA : KH 3040
GLEI : KG +1234567+02
ZT   : T 14
 : U E 0.0
 : BE
FB 5
NAME : VENTIL
BEZ : AUF E BI
BEZ : ZAHL D KF
BEZ : TEXT D KC
BEZ : BYTE D KY
BEZ : BILD D KM
BEZ : ZEIT D KT
BEZ : ZAEL D KZ
BEZ : HEXA D KH
BEZ : GLEI D KG
BEZ : ZT T
 : U =AUF
 : BE
)";

// 4.3.2, 9.4: the jump over a parameter list is not shown, and only jumps that somebody wrote have
// labels. S5-FB-06
TEST(Listing, ParametersAreNoInstructions) {
  const auto c = compileText(kCalls);
  ASSERT_TRUE(c.ok());
  const std::string text = listing(c.program);
  EXPECT_EQ(text.find("SPA   ="), std::string::npos) << text;
  EXPECT_EQ(text.find("M001"), std::string::npos) << text;
  for (const char* line :
       {"NAME : VENTIL\n", "AUF  : E 2.0\n", "ZAHL : KF +25\n", "TEXT : KC AB\n",
        "BYTE : KY 10,255\n", "BILD : KM 00111110 01011011\n", "ZEIT : KT 10.2\n",
        "ZAEL : KZ 100\n", "HEXA : KH 3040\n", "GLEI : KG +1234567+02\n", "ZT   : T 14\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  expectBack(c);
}

TEST(Listing, CodeShowsParametersAsTheManualDoes) {
  const auto c = compileText(kCalls);
  ASSERT_TRUE(c.ok());
  const std::string text = codeOf(c, {mc5::BlockType::Ob, 1});
  EXPECT_EQ(text,
            "0000: 3D05 2D0C        SPA   FB 5\n"
            "                       NAME : VENTIL\n"
            "0002: C002             AUF  : E 2.0\n"
            "0003: 0019             ZAHL : KF +25\n"
            "0004: 4142             TEXT : KC AB\n"
            "0005: 0AFF             BYTE : KY 10,255\n"
            "0006: 3E5B             BILD : KM 00111110 01011011\n"
            "0007: 2010             ZEIT : KT 10.2\n"
            "0008: 0100             ZAEL : KZ 100\n"
            "0009: 3040             HEXA : KH 3040\n"
            "000A: 0462 C3EF        GLEI : KG +1234567+02\n"
            "000C: 020E             ZT   : T 14\n"
            "000D: C000             U     E 0.0\n"
            "000E: 6500             BE\n");
}

// Without its declaration a list is known by the jump over it; 3040 would begin an instruction.
TEST(Listing, MachineCodeAloneHasParametersToo) {
  const std::vector<std::uint16_t> code{0x3D05, 0x2D03, 0x3040, 0x3001, 0xC000, 0x6500};
  std::string text;
  for (const mc5::Line& line : mc5::disassemble(code)) text += line.text + "; ";
  EXPECT_EQ(text, "SPA   FB 5; SPA   =+3; KH 3040; KH 3001; U     E 0.0; BE; ");
  const std::vector<std::uint16_t> cut{0x3D05, 0x2D09, 0xC000};
  EXPECT_EQ(mc5::disassemble(cut).back().text, "U     E 0.0");
}

// A jump into another network, into an instruction or a list has no label to lead to.
TEST(Listing, JumpsByDistanceStayThat) {
  const auto c = compileText(R"(FB 6
NAME : SPRUENGE
M001 : SPA =+3
 : SPB =+2
 : L KH 1234
 : SPA =+3
 : SPA =M001
NETZWERK 2
 : SPA =+5
 : SPA FB 5
EIN : M 30.0
WERT : KF +1
 : BE
FB 5
NAME : TEST
BEZ : EIN E BI
BEZ : WERT D KF
 : BE
)");
  ASSERT_TRUE(c.ok()) << source::format(c.problems.list().front(), nullptr);
  const std::string text = listing(c.program);
  EXPECT_NE(text.find("SPB   =+2"), std::string::npos) << text;    // into L KH
  EXPECT_NE(text.find("SPA   =M002"), std::string::npos) << text;  // M001 is taken
  EXPECT_NE(text.find("SPA   =+3"), std::string::npos) << text;    // into network 2
  expectBack(c);
}

// Behind the last word of a block there is no line that could have a label.
TEST(Listing, AJumpBehindTheEndStaysADistance) {
  const auto c = compileText("FB 6\nNAME : X\n : SPA =+2\n : BE\n");
  ASSERT_TRUE(c.ok()) << source::format(c.problems.list().front(), nullptr);
  EXPECT_NE(listing(c.program).find("SPA   =+2"), std::string::npos) << listing(c.program);
  expectBack(c);
}

// Each comment stands on the line of its parameter, whatever words the ones before take.
TEST(Listing, CommentsOfParametersStayWithThem) {
  const auto c = compileText(
      "OB 1\n : SPA FB 5\nNAME : DREI ! none\nEINS : KG +1234567+02 ! one\nZWEI : M 30.0 ! two\n"
      "DREI : T 4 ! three\n : BE\n"
      "FB 5\nNAME : DREI\nBEZ : EINS D KG\nBEZ : ZWEI E BI\nBEZ : DREI T\n : BE\n");
  ASSERT_TRUE(c.ok()) << source::format(c.problems.list().front(), nullptr);
  std::stringstream lines(listing(c.program));
  std::map<std::string, std::string> found;
  for (std::string line; std::getline(lines, line);)
    for (const char* name : {"EINS", "ZWEI", "DREI"})
      if (line.find("! ") != std::string::npos && line.find(name) < line.find(':'))
        found[name] = line.substr(line.find("! "));
  const std::map<std::string, std::string> expected = {
      {"EINS", "! one"}, {"ZWEI", "! two"}, {"DREI", "! three"}};
  EXPECT_EQ(found, expected) << lines.str();
}

TEST(Listing, KeepsCommentsAndTexts) {
  const auto c = compileText(R"(! the plant
OB 1  ! start
! both buttons
 : U E 0.0          ! first
                    (and more)
 : U E 0.1 second
 : SPA FB 5 // call
! inside
AUF  : E 2.0  ! valve
 : BE
! behind
FB 5
NAME : VENTIL ! name
// declared
BEZ : AUF E BI ! which
 : U =AUF
M1 : NOP 0 ! here
NETZWERK 2
 : BE
DB 10
; words
   0: KS 'TEXT A'  ! text
   3: KH 1234 ! word
)");
  ASSERT_TRUE(c.ok()) << source::format(c.problems.list().front(), nullptr);
  const std::string text = listing(c.program);
  for (const char* words :
       {"! the plant", "! start", "! both buttons", "! first", "! (and more)", "! second",
        "// call", "! inside", "! valve", "! behind", "! name", "// declared", "! which", "! here",
        "; words", "0: KS 'TEXT A'", "! text", "3: KH 1234", "! word"})
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
  expectBack(c);
  EXPECT_EQ(listing(compileText(text).program), text);
}

TEST(Listing, ChecksComeBack) {
  const auto c = compileText("OB 1\n : L KF 5 //= AKKU1 = KH 0005\n //= VKE = 0\n : BE\n", true);
  ASSERT_TRUE(c.ok());
  const auto again = compileText(listing(c.program), true);
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again.program.begin()->second.checks.size(), 2u) << listing(c.program);
}

TEST(Listing, ExamplesComeBack) {
  unsigned count = 0;
  for (const auto& folder : std::filesystem::directory_iterator(kExamples)) {
    if (!folder.is_directory()) continue;
    const bool project = std::filesystem::exists(folder.path() / "merker.toml");
    std::vector<std::vector<source::SourceFile>> programs(1);
    source::SymbolTable symbols(source::Language::Step5);
    Problems none;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (source::isSymbolFile(entry.path().string()))
        readSymbols(*source::readSource(entry.path().string()), symbols, none);
      if (entry.path().extension() != ".s5") continue;
      programs.back().emplace_back(entry.path().string(), fileText(entry.path()));
      if (!project) programs.emplace_back();
    }
    for (const auto& files : programs) {
      if (files.empty()) continue;
      const auto c = compile(files, false, {}, &symbols);
      ASSERT_TRUE(c.ok()) << folder.path();
      expectBack(c);
      ++count;
    }
  }
  EXPECT_GT(count, 10u);
}

// *** behind a list ends the network, it is no comment of the list.
TEST(Listing, NetworksEndBehindCalls) {
  const auto c = compileText(
      "OB 1\n : SPA FB 5\nNAME : LEER\n***\n : U E 0.0\n : BE\nFB 5\nNAME : LEER\n : BE\n");
  ASSERT_TRUE(c.ok());
  EXPECT_EQ(words(c, mc5::BlockType::Ob, 1),
            (std::vector<std::uint16_t>{0x3D05, 0x2D01, 0x10FF, 0xC000, 0x6500}));
  expectBack(c);
}

// What printers put on each page, and the word that would come next (B of the trials).
TEST(Listing, PrintedPagesAreRead) {
  const std::string text =
      "PB 5            LAE=8       BLATT  1\n : U E 0.0\nBLATT 2\n : = A 0.0\n : BE\n"
      "\fFB 7   TEST   BIB=12  LAE=9\nBLATT : 3\nNAME : TEST\n : BE\n"
      "DB 9\n 0: KH = 1234\n 1: KF = +5\n 2:\nBLATT 4\n";
  const auto c = compileText(text);
  ASSERT_TRUE(c.ok()) << source::format(c.problems.list().front(), nullptr);
  EXPECT_EQ(words(c, mc5::BlockType::Pb, 5), (std::vector<std::uint16_t>{0xC000, 0xD880, 0x6500}));
  EXPECT_EQ(words(c, mc5::BlockType::Db, 9), (std::vector<std::uint16_t>{0x1234, 5}));
  EXPECT_EQ(c.program.at({mc5::BlockType::Fb, 7}).name, "TEST");
  EXPECT_EQ(c.program.at({mc5::BlockType::Fb, 7}).library, 12u);
}

// Random listings of all operations: source to code to listing to code. S5-OPC-01
class RandomListing {
 public:
  explicit RandomListing(unsigned seed) : random_(seed) {}

  std::string text() {
    std::string result = "FB 9\nNAME : RUFE\n";
    for (std::size_t i = 0; i < std::size(kTypes); ++i)
      result += form("BEZ : P{} {}\n", i, kTypes[i]);
    result += body(true) + " : BE\nOB 1\n" + body(false) + " : BE\n";
    return result + "FB 8\nNAME : LEER\n : BE\nPB 3\n : BE\n";
  }

 private:
  static constexpr const char* kTypes[] = {"E BI", "A W", "D KF", "D KG", "D KC", "B", "T", "Z"};
  static constexpr const char* kActual[] = {"M 30.1", "MW 40", "KF -7", "KG +1234567+02",
                                            "KC AB",  "PB 3",  "T 3",   "Z 4"};
  static constexpr const char* kBasic[] = {"U E 1.2",  "=  A 3.4", "L KH 3D09", "L KG +1000000+01",
                                           "T MW 200", "L KT 5.1", "SE T 3",    "R Z 2",
                                           "SPB PB 3", "A DB 10",  "xF",        "NOP 1",
                                           "BLD 7",    "SPA FB 8", "U D 3.12",  "L KC X"};
  static constexpr const char* kMore[] = {"SU D 205.10", "SLW 4",   "ADD KF -300", "SPA =L1",
                                          "SPZ =L2",     "SPS =L3", "B MW 30",     "U =P0",
                                          "LD =P3",      "TNW 5"};
  template <typename... A>
  static std::string form(fmt::format_string<A...> pattern, A&&... a) {
    return fmt::format(pattern, std::forward<A>(a)...);
  }
  unsigned any(unsigned n) { return static_cast<unsigned>(random_()) % n; }

  std::string call() {
    std::string text = " : SPA FB 9\nNAME : RUFE\n";
    for (std::size_t i = 0; i < std::size(kTypes); ++i) text += form("P{} : {}\n", i, kActual[i]);
    return text;
  }

  std::string body(bool fb) {
    std::string text;
    const unsigned at[] = {any(20), any(20), any(20)};
    for (unsigned i = 0; i < 20; ++i) {
      for (unsigned l = 0; l < 3 && fb; ++l)
        if (at[l] == i) text += form("L{} :\n", l + 1);
      if (any(6) == 0)
        text += call();
      else if (fb && any(2) == 0)
        text += form(" : {} ! {}\n", kMore[any(std::size(kMore))], i);
      else
        text += form(" : {}\n", kBasic[any(std::size(kBasic))]);
    }
    return text;
  }

  std::mt19937 random_;
};

TEST(Listing, RandomProgramsComeBack) {
  unsigned compiled = 0;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    const auto c = compileText(RandomListing(seed).text());
    if (!c.ok()) continue;  // a jump too far
    ++compiled;
    expectBack(c);
    if (HasFailure()) FAIL() << "seed " << seed;
  }
  EXPECT_GT(compiled, 200u);
}

}  // namespace
}  // namespace merker::step5
