// Symbols of an assignment list in listings (docs/formats/listing.md).
#include "compile.h"
#include "step5/variable.h"

namespace merker::step5 {
namespace {

source::SymbolTable table() {
  source::SymbolTable table(source::Language::Step5);
  Problems problems;
  readSymbols(source::SourceFile("aZ0.SEQ",
                                 "\tE 1.0\tTASTER\n\tA 2.0\tMOTOR\n\tE 1.1\t1S3\n\tT 5\tZEIT\n"
                                 "\tPB 7\tFOLGE\n\tFB 9\tVENTIL\n\tDB 20\tDATEN\n\tDW 3\tSOLL\n"
                                 "\tD 4.9\tBIT9\n\tPY 4\tWAAGE\n\tMW 10\tWERT\n\tE 200.0\tFERN\n"),
              table, problems);
  EXPECT_EQ(problems.size(), 0u);
  return table;
}

Compilation withSymbols(const std::string& text) {
  const source::SymbolTable symbols = table();
  std::vector<source::SourceFile> files;
  files.emplace_back("t.s5", text);
  return compile(files, true, {}, &symbols);
}

std::string problemsIn(const std::string& text) {
  std::string list;
  const Compilation compilation = withSymbols(text);
  for (const Problem& p : compilation.problems.list())
    list += std::string(p.name()) + "@" + std::to_string(p.position.line) + ":" +
            std::to_string(p.position.column) + " ";
  return list;
}

constexpr const char* kSymbolic =
    "OB 1\n U -TASTER  Ein\n O -1S3\n U - taster\n = \"Motor\"\n L KT 5.1\n SE -ZEIT\n"
    " SPA -FOLGE\n A -DATEN\n L -SOLL\n T -WAAGE! Waage\n SPB -VENTIL\nNAME : VENTIL\n"
    "EIN : -TASTER\nAUS : -MOTOR // x\nDB : -DATEN\n BE\n";
constexpr const char* kAbsolute =
    "OB 1\n U E 1.0\n O E 1.1\n U E 1.0\n = A 2.0\n L KT 5.1\n SE T 5\n"
    " SPA PB 7\n A DB 20\n L DW 3\n T PB 4\n SPB FB 9\nNAME : VENTIL\n"
    "EIN : E 1.0\nAUS : A 2.0\nDB : DB 20\n BE\n";
constexpr const char* kOthers =
    "PB 7\n BE\nDB 20\nFB 9 VENTIL\nBEZ : EIN E BI\nBEZ : AUS A BI\nBEZ : DB B\n"
    " U =EIN\n = =AUS\n BE\n";

TEST(Symbol, StandsForItsOperand) {
  const Compilation symbolic = withSymbols(std::string(kSymbolic) + kOthers);
  const Compilation absolute = compileText(std::string(kAbsolute) + kOthers);
  ASSERT_TRUE(absolute.ok());
  for (const Problem& p : symbolic.problems.list()) ADD_FAILURE() << p.name() << p.position.line;
  EXPECT_EQ(words(symbolic, mc5::BlockType::Ob, 1), words(absolute, mc5::BlockType::Ob, 1));
}

TEST(Symbol, IsPrintedInAListingThatCompilesToTheSame) {
  const Compilation first = withSymbols(std::string(kSymbolic) + kOthers);
  const source::SymbolTable symbols = table();
  const std::string text = listing(first.program, &symbols);
  for (const char* line :
       {"U     -TASTER", "O     -1S3", "=     -MOTOR", "SE    -ZEIT", "SPA   -FOLGE",
        "A     -DATEN", "T     -WAAGE", "SPB   -VENTIL", "EIN  : -TASTER", "DB   : -DATEN"})
    EXPECT_NE(text.find(line), std::string::npos) << line << '\n' << text;
  const Compilation again = withSymbols(text);
  EXPECT_TRUE(again.ok());
  EXPECT_EQ(words(again, mc5::BlockType::Ob, 1), words(first, mc5::BlockType::Ob, 1));
}

TEST(Symbol, IsReportedWhereItIsUnknownOrDoesNotFit) {
  EXPECT_EQ(problemsIn("PB 1\n U -NICHTDA\n BE\n"), "P0303@2:4 ");
  EXPECT_EQ(problemsIn("PB 1\n U -WERT\n BE\n"), "P1109@2:4 ");
  EXPECT_EQ(problemsIn("PB 1\n SPA -WAAGE\n BE\n"), "P1109@2:6 ");
  EXPECT_EQ(problemsIn("PB 1\n U -FERN\n BE\n"), "P1112@2:4 ");
  EXPECT_EQ(problemsIn("FB 8\nBEZ : X E BI\n BE\nPB 1\n SPA FB 8\nX : -NIE\n BE\n"), "P0303@6:5 ");
  EXPECT_EQ(problemsOf("PB 1\n U -START\n BE\n"), "P0303@2:4");
}

TEST(Symbol, StandsInChecks) {
  EXPECT_EQ(problemsIn("PB 1\n U -TASTER //= -TASTER = 0, -WERT = 0, \"DATEN\".DW 3 = 0\n BE\n"),
            "");
  EXPECT_EQ(problemsIn("PB 1\n U -TASTER //= -NIE = 0\n BE\n"), "P0303@2:16 ");
}

TEST(Symbol, NamesAVariable) {
  const source::SymbolTable symbols = table();
  EXPECT_EQ(parseVariable("-motor", &symbols)->operand, parseVariable("A 2.0")->operand);
  EXPECT_EQ(parseVariable("\"1S3\"", &symbols)->operand, parseVariable("E 1.1")->operand);
  for (const char* text : {"-DATEN.DW 3", "\"DATEN\".DW 3", "DB20.-SOLL", "-DATEN.-SOLL"}) {
    ASSERT_TRUE(parseVariable(text, &symbols)) << text;
    EXPECT_EQ(parseVariable(text, &symbols)->db, 20) << text;
    EXPECT_EQ(parseVariable(text, &symbols)->operand, parseVariable("DB20.DW 3")->operand) << text;
  }
  EXPECT_EQ(parseVariable("DB20.-BIT9", &symbols)->operand, parseVariable("DB20.D 4.9")->operand);
  for (const char* text : {"-NIE", "-FOLGE", "-SOLL", "-DATEN", "-MOTOR x", "-MOTOR.DW 3"})
    EXPECT_FALSE(parseVariable(text, &symbols)) << text;
  EXPECT_EQ(symbolName("-MOTOR"), "MOTOR");
  EXPECT_EQ(symbolName("\"A B\""), "A B");
  EXPECT_EQ(symbolName("E 1.0"), "");
}

}  // namespace
}  // namespace merker::step5
