#include <gtest/gtest.h>

#include "source/symbol_table.h"

namespace merker::source {
namespace {

struct Reading {
  SymbolTable table;
  Problems problems;
};

Reading read(std::string name, std::string text) {
  Reading result;
  readSymbols(SourceFile(std::move(name), std::move(text)), result.table, result.problems);
  return result;
}

Reading readData(const std::string& name) {
  Reading result;
  const auto file = readSource(MERKER_SOURCE_DIR "/tests/unit/source/data/" + name);
  EXPECT_TRUE(file) << name;
  if (file) readSymbols(*file, result.table, result.problems);
  return result;
}

std::string problemsOf(const Reading& reading) {
  std::string text;
  for (const Problem& p : reading.problems.list())
    text += std::string(text.empty() ? "" : " ") + std::string(p.name());
  return text;
}

TypeCode typeOf(const Reading& reading, std::string_view name) {
  const Symbol* const symbol = reading.table.find(name);
  return symbol ? symbol->type : TypeCode::Any;
}

// S7-SYM-17: the same table in every format.
class Formats : public testing::TestWithParam<const char*> {};

TEST_P(Formats, sameSymbols) {
  const Reading reading = readData(GetParam());
  const bool typed = std::string_view(GetParam()) != "plant.seq";
  EXPECT_EQ(problemsOf(reading), "");
  ASSERT_EQ(reading.table.list().size(), 12u);
  const Symbol* const motor = reading.table.find("MOTOR");
  ASSERT_NE(motor, nullptr);
  EXPECT_EQ(motor->name, "Motor");
  EXPECT_EQ(motor->address, *parseSymbolAddress("A 1.0", {}));
  EXPECT_EQ(motor->type, TypeCode::Bool);
  EXPECT_EQ(motor->comment, "treibt das Förderband");
  EXPECT_NE(reading.table.find("Lichtschranke groß"), nullptr);
  EXPECT_EQ(reading.table.find("Stückzahl")->comment, "seit Schichtbeginn");
  EXPECT_EQ(typeOf(reading, "Sollwert"), typed ? TypeCode::Int : TypeCode::Word);
  EXPECT_EQ(typeOf(reading, "Uhrzeit"), typed ? TypeCode::TimeOfDay : TypeCode::DWord);
  EXPECT_EQ(typeOf(reading, "Takt"), TypeCode::Timer);
  EXPECT_EQ(typeOf(reading, "Stückzahl"), TypeCode::Counter);
  EXPECT_EQ(typeOf(reading, "Achse"), TypeCode::Void);
  if (!typed) return;
  EXPECT_EQ(reading.table.find("Rezept")->blockType, (BlockId{BlockKind::UDT, 2}));
  EXPECT_EQ(reading.table.find("Achse_DB")->blockType, (BlockId{BlockKind::FB, 3}));
  EXPECT_EQ(reading.table.find("Achse")->blockType, std::nullopt);
}

INSTANTIATE_TEST_SUITE_P(All, Formats,
                         testing::Values("plant.sdf", "plant.asc", "plant.seq", "plant.dif",
                                         "plant.sym"),
                         [](const auto& test) { return std::string(test.param).substr(6); });

// S7-SYM-16
TEST(ReadSymbols, typesThatFit) {
  const std::pair<std::string, std::string> good[] = {
      {"M 1.0", "BOOL"},
      {"MB 1", "BYTE CHAR"},
      {"MW 1", "WORD INT S5TIME DATE"},
      {"MD 1", "DWORD DINT REAL TIME TIME_OF_DAY TOD"},
      {"T 1", "TIMER"},
      {"Z 1", "COUNTER"}};
  for (const auto& [operand, types] : good)
    for (const std::string type :
         {"BOOL", "BYTE", "CHAR", "WORD", "INT", "S5TIME", "DATE", "DWORD", "DINT", "REAL", "TIME",
          "TIME_OF_DAY", "TOD", "TIMER", "COUNTER", "STRING", "FB 1"}) {
      const bool fits = (' ' + types + ' ').find(' ' + type + ' ') != std::string::npos;
      EXPECT_EQ(problemsOf(read("a.sym", "X " + operand + " " + type)), fits ? "" : "P0806")
          << operand << " " << type;
    }
}

TEST(ReadSymbols, typesOfBlocks) {
  EXPECT_EQ(problemsOf(read("a.sym",
                            "X DB 5 DB 5\nY DB 6 SFB 4\nZ DB 7 UDT 1\nO OB 1 OB 1\nV VAT 1 VAT 1")),
            "");
  for (const char* text : {"X DB 5 DB 6", "X FB 1 FB 2", "X DB 5 FC 1", "X OB 1 INT", "X FC 1 DB 1",
                           "X VAT 1 VAT 2", "X UDT 1 DB 1", "X DB 1 T 1"})
    EXPECT_EQ(problemsOf(read("a.sym", text)), "P0806") << text;
}

// S7-SYM-01
TEST(ReadSymbols, lengths) {
  const std::string name24(24, 'n'), comment80(80, 'c');
  EXPECT_EQ(problemsOf(read("a.sym", name24 + " M 0.0 BOOL // " + comment80)), "");
  EXPECT_EQ(problemsOf(read("a.sym", name24 + "n M 0.0")), "P0802");
  EXPECT_EQ(problemsOf(read("a.sym", "X M 0.0 // " + comment80 + "c")), "P0803");
  EXPECT_EQ(problemsOf(read("a.sym", "ÄÖÜäöüßÄÖÜäöüßÄÖÜäöüßÄÖÜ M 0.0")),
            "");  // characters, not bytes
}

// S7-SYM-03, S7-OPEN-31
TEST(ReadSymbols, namesAreUniqueIgnoringCase) {
  const Reading reading = read("a.sym", "Motor A 1.0\nmotor A 1.1\n");
  ASSERT_EQ(problemsOf(reading), "P0807");
  EXPECT_EQ(reading.problems.list()[0].message, "symbol 'motor' already exists (a.sym:1)");
  EXPECT_EQ(reading.table.list().size(), 1u);
}

TEST(ReadSymbols, twoNamesForOneOperandAreDoubtful) {
  const Reading reading = read("a.sym", "Motor A 1.0\nDrive Q 1.0\n");
  EXPECT_EQ(problemsOf(reading), "P0808");
  EXPECT_FALSE(reading.problems.hasErrors());
  EXPECT_EQ(reading.table.findAddress(*parseSymbolAddress("A 1.0", {}))->name, "Motor");
  EXPECT_EQ(reading.table.list().size(), 2u);
}

TEST(ReadSymbols, problemsNameThePlace) {
  const Reading reading = read("a.sym", "\n  Größe  MW 10   REAL\n");
  ASSERT_EQ(problemsOf(reading), "P0806");
  EXPECT_EQ(reading.problems.list()[0].position, (Position{"a.sym", 2, 18, 4}));
  EXPECT_EQ(reading.problems.list()[0].message,
            "type REAL does not match MW 10; valid: WORD, INT, S5TIME, DATE");
}

TEST(ReadSymbols, linesThatAreNone) {
  EXPECT_EQ(problemsOf(read("a.sym", "Motor")), "P0810");
  EXPECT_EQ(problemsOf(read("a.sym", "\"\" A 1.0")), "P0801");
  EXPECT_EQ(problemsOf(read("a.sym", "Motor LW 2")), "P0804");
  EXPECT_EQ(problemsOf(read("a.sdf", "Motor")), "P0810");
  EXPECT_EQ(problemsOf(read("a.sdf", R"("a","M 0.0","BOOL","x","y")")), "P0810");
  EXPECT_EQ(problemsOf(read("a.asc", "Motor A 1.0")), "P0810");
  EXPECT_EQ(problemsOf(read("a.seq", "A 1.0 Motor")), "P0810");
  EXPECT_EQ(problemsOf(read("a.dif", "TABLE\n0,1\n\"\"\n")), "P0810");
  EXPECT_EQ(problemsOf(read("a.csv", "")), "P0811");
}

// As Excel stores it: blank lines between the pairs. What is wrong is told where it stands.
TEST(ReadSymbols, blankLinesInDif) {
  const std::string head = "TABLE\n0,1\n\"\"\nDATA\n0,0\n\"\"\n";
  const Reading good =
      read("a.dif", head +
                        "-1,0\nBOT\n\n1,0\n\"Motor\"\n\n1,0\n\"A 1.0\"\n1,0\n\"BOOL\"\n1,0\n"
                        "\"main drive\"\n-1,0\nEOD\n");
  EXPECT_EQ(problemsOf(good), "");
  ASSERT_NE(good.table.find("Motor"), nullptr);
  EXPECT_EQ(good.table.find("Motor")->comment, "main drive");
  const Reading bad = read("a.dif", head + "-1,0\nBOT\n1,0\n\"Motor\"\nA 1.0\n1,0\n-1,0\nEOD\n");
  EXPECT_EQ(problemsOf(bad), "P0810");
  EXPECT_EQ(bad.problems.list().at(0).position.line, 11u);
}

TEST(ReadSymbols, blankLinesAndComments) {
  const Reading reading = read("A.TXT", "// head\n\n  \t\n\"a // b\"  M 0.0 // c // d\n");
  EXPECT_EQ(problemsOf(reading), "");
  ASSERT_NE(reading.table.find("a // b"), nullptr);
  EXPECT_EQ(reading.table.find("a // b")->comment, "c // d");
}

TEST(ReadSymbols, exportsWithTrimmedOrForeignFields) {
  const Reading sdf =
      read("a.sdf", "\"Motor\",\"A 1.0\",\"BOOL\",\"say \"\"go\"\", then\"\nPump , A 1.1 , BOOL\n");
  EXPECT_EQ(problemsOf(sdf), "");
  EXPECT_EQ(sdf.table.find("Motor")->comment, "say \"go\", then");
  EXPECT_NE(sdf.table.find("Pump"), nullptr);
  const Reading single = read("a.sdf", "\"Motor\",\"A 1.0\",\"BOOL\",\"say \"go\" then  \"");
  EXPECT_EQ(single.table.find("Motor")->comment, "say \"go\" then");
  EXPECT_EQ(problemsOf(read("a.asc", "126,Motor                   A       1.0")), "");
  EXPECT_EQ(problemsOf(read("a.asc", "126,Time                    MD     20   TIME_OF_DA")), "");
}

TEST(IsSymbolFile, byExtension) {
  EXPECT_TRUE(isSymbolFile("plant/Symbols.SDF"));
  EXPECT_TRUE(isSymbolFile("a.sym"));
  EXPECT_FALSE(isSymbolFile("a.txt"));
  EXPECT_FALSE(isSymbolFile("a.sdf/b"));
  EXPECT_FALSE(isSymbolFile("sdf"));
}

}  // namespace
}  // namespace merker::source
