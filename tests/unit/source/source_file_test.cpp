#include "source/source_file.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace merker::source {
namespace {

std::string data(const std::string& name) {
  return MERKER_SOURCE_DIR "/tests/unit/source/data/" + name;
}

TEST(SourceFile, allLineEnds) {
  const SourceFile file("a.awl", "one\r\ntwo\nthree\rfour\r\rsix\n");
  ASSERT_EQ(file.lineCount(), 6u);
  EXPECT_EQ(file.line(1), "one");
  EXPECT_EQ(file.line(2), "two");
  EXPECT_EQ(file.line(3), "three");
  EXPECT_EQ(file.line(4), "four");
  EXPECT_EQ(file.line(5), "");
  EXPECT_EQ(file.line(6), "six");
  EXPECT_EQ(file.line(0), "");
  EXPECT_EQ(file.line(7), "");
}

TEST(SourceFile, emptyText) {
  const SourceFile file("a.awl", "");
  EXPECT_EQ(file.lineCount(), 1u);
  EXPECT_EQ(file.position(0), (Position{"a.awl", 1, 1, 1}));
  EXPECT_EQ(file.position(99), (Position{"a.awl", 1, 1, 1}));
}

TEST(SourceFile, columnsCountCharacters) {
  const SourceFile file("a.awl", "L 'ä€'\r\n\tT MW 10\r\n");
  EXPECT_EQ(file.position(2, 7), (Position{"a.awl", 1, 3, 4}));
  EXPECT_EQ(file.position(14, 5), (Position{"a.awl", 2, 4, 5}));
  EXPECT_EQ(file.position(8), (Position{"a.awl", 1, 6, 1}));
  EXPECT_EQ(file.position(19, 99), (Position{"a.awl", 2, 9, 1}));  // behind the end of the line
}

RC_GTEST_PROP(SourceFile, everyOffsetHasAPlace, ()) {
  const auto text = *rc::gen::container<std::string>(
      rc::gen::element('a', ' ', '\t', '\r', '\n', '\xC3', '\xA4'));
  const SourceFile file("a.awl", text);
  std::string joined;
  for (std::uint32_t i = 1; i <= file.lineCount(); ++i) joined += file.line(i);
  std::string expected = text;
  std::erase_if(expected, [](char c) { return c == '\r' || c == '\n'; });
  RC_ASSERT(joined == expected);
  for (std::size_t i = 0; i <= text.size() + 1; ++i) {
    const Position at = file.position(i);
    RC_ASSERT(at.line >= 1u && at.line <= file.lineCount());
    RC_ASSERT(at.column <= file.line(at.line).size() + 1);
  }
}

TEST(ReadSource, everyEncoding) {
  for (const char* name :
       {"conveyor-cp1252.awl", "conveyor-cp850.awl", "conveyor-utf8.awl", "conveyor-utf16.awl"}) {
    const auto file = readSource(data(name));
    ASSERT_TRUE(file) << name;
    EXPECT_EQ(file->name(), data(name));
    EXPECT_EQ(file->line(1), "// Förderbänder Überlauf, Größe") << name;
    EXPECT_EQ(file->lineCount(), 3u) << name;
  }
  const auto frames = readSource(data("conveyor-cp437.awl"));
  ASSERT_TRUE(frames);
  EXPECT_EQ(frames->line(1), "// ╒══════════╕");
  EXPECT_EQ(frames->line(2), "// │ Förderbänder │");
}

TEST(ReadSource, refusals) {
  EXPECT_EQ(readSource(data("missing.awl")).error().message,
            "cannot read " + data("missing.awl") + ": no such file");
  EXPECT_EQ(readSource(data("")).error().name(), "P0101");
  EXPECT_EQ(readSource(data("block.bin")).error().name(), "P0102");
}

TEST(Format, caretUnderThePlace) {
  const SourceFile file("file.awl", "U E 0.0\n\tL  MB 300\r\n");
  const Problem problem = makeProblem(ProblemCode::P0202, file.position(12, 6), "MB 300", "0..255");
  EXPECT_EQ(format(problem, &file),
            "file.awl:2:5: error: MB 300 is outside 0..255 [P0202]\n"
            "\tL  MB 300\n"
            "\t   ^~~~~~");
  EXPECT_EQ(format(problem, nullptr), "file.awl:2:5: error: MB 300 is outside 0..255 [P0202]");
}

TEST(Format, characterColumnsAndEnds) {
  const SourceFile file("a.awl", "ä\x01ü x");
  EXPECT_EQ(format({ProblemCode::P0104, {"a.awl", 1, 3, 99}, "m"}, &file),
            "a.awl:1:3: warning: m [P0104]\nä ü x\n  ^~~");
  EXPECT_EQ(format({ProblemCode::P0104, {"a.awl", 1, 6, 1}, "m"}, &file),
            "a.awl:1:6: warning: m [P0104]\nä ü x\n     ^");
}

// A machine-written line of megabytes: only the surroundings are shown.
TEST(Format, longLinesAreCut) {
  const SourceFile file("a.awl", std::string(300, 'a') + "äX" + std::string(300, 'b'));
  const std::string text = format(makeProblem(ProblemCode::P0104, file.position(302)), &file);
  EXPECT_EQ(text, "a.awl:1:302: warning: the source contains no block [P0104]\n..." +
                      std::string(78, 'a') + "äX" + std::string(80, 'b') + "...\n" +
                      std::string(82, ' ') + '^');
}

TEST(SourceFile, columnsOfLongLines) {
  std::string line;
  for (int i = 0; i < 3000; ++i) line += "aäö";
  const SourceFile file("a.awl", "ä\n" + line + "\n");
  for (const std::size_t i : {0, 1, 3, 5, 1022, 1024, 2048, 14995}) {
    const auto column = characterCount(line.substr(0, i)) + 1;
    EXPECT_EQ(file.position(3 + i, 5).column, column) << i;
  }
  EXPECT_EQ(file.position(3, 15000).length, 9000u);
}

TEST(Format, placesWithoutLineOrColumn) {
  const SourceFile file("a.awl", "x");
  EXPECT_EQ(format({ProblemCode::P0101, {"a.awl"}, "m"}, &file), "a.awl: error: m [P0101]");
  EXPECT_EQ(format({ProblemCode::P0101, {}, "m"}, nullptr), "error: m [P0101]");
  EXPECT_EQ(format({ProblemCode::P0101, {"a.awl", 1, 0}, "m"}, &file),
            "a.awl:1: error: m [P0101]\nx");
}

}  // namespace
}  // namespace merker::source
