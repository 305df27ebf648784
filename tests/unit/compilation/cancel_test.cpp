#include <gtest/gtest.h>
#include <unistd.h>

#include <ctime>
#include <filesystem>
#include <fstream>
#include <stop_token>

#include "compilation/build.h"

namespace merker::compilation {
namespace {

project::Project program(const std::string& name, const std::string& text, std::stop_token stop) {
  return project::load(name, {}, {{name, text}}, std::move(stop));
}

// So large that a part that does not look at the request shows in the time.
std::string largeBlock() {
  std::string text = "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n";
  for (int i = 0; i < 100'000; ++i) text += "U E 0.0;\n= A 0.0;\n";
  return text + "END_FUNCTION\n";
}

std::string largeListing() {
  std::string text = "PB 1\n";
  for (int i = 0; i < 100'000; ++i) text += "U E 0.0\n= A 0.0\n";
  return text + "BE\n";
}

std::string manyBlocks() {
  std::string text;
  for (int i = 1; i < 20'000; ++i)
    text += "DATA_BLOCK DB " + std::to_string(i % 900 + 1) +
            "\nSTRUCT\na : ARRAY [0..99] OF INT := 100 (7);\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
  return text;
}

double seconds(const std::string& name, const std::string& text, std::stop_token stop) {
  const std::clock_t before = std::clock();
  (void)build(program(name, text, std::move(stop)), true);
  return static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
}

TEST(Cancel, oneClearProblemAndNoProgram) {
  std::stop_source source;
  source.request_stop();
  const Build cancelled = build(program("a.awl", largeBlock(), source.get_token()), false);
  ASSERT_EQ(cancelled.problems.size(), 1u);
  EXPECT_EQ(cancelled.problems.list()[0].code, ProblemCode::P0713);
  EXPECT_EQ(cancelled.problems.list()[0].position.file, "a.awl");
  EXPECT_FALSE(cancelled.ok());
  EXPECT_EQ(cancelled.blocks(), 0u);
}

TEST(Cancel, aRequestThatNeverComesChangesNothing) {
  const std::stop_source source;
  const std::string text = "PB 1\nU E 0.0\n= A 0.0\nBE\n";
  EXPECT_TRUE(build(program("a.s5", text, source.get_token()), false).ok());
}

TEST(Cancel, noPartOfTheWorkGoesOn) {
  std::stop_source source;
  source.request_stop();
  for (const auto& [name, text] : {std::pair<const char*, std::string>{"a.awl", largeBlock()},
                                   {"a.awl", manyBlocks()},
                                   {"a.s5", largeListing()}})
    EXPECT_LT(seconds(name, text, source.get_token()) * 10, seconds(name, text, {})) << name;
}

// The other control of [coupling] is a project of its own.
TEST(Cancel, thePartnerIsNotCompiledEither) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("merker-cancel-" + std::to_string(::getpid()));
  const auto write = [&](const std::string& name, const std::string& text) {
    std::filesystem::create_directories((folder / name).parent_path());
    std::ofstream(folder / name) << text;
  };
  const std::string cpu = "[cpu]\nmodel = \"SINUMERIK 820 GA3\"\n";
  write("a/merker.toml", cpu + "[coupling]\npartner = \"../b\"\n");
  write("a/a.s5", "OB 1\nBE\n");
  write("b/merker.toml", cpu);
  write("b/b.s5", largeListing());
  const auto seconds = [&](std::stop_token stop) {
    const std::clock_t before = std::clock();
    const Build built = build(project::load((folder / "a").string(), {}, {}, stop), true);
    EXPECT_EQ(built.problems.list()[0].code == ProblemCode::P0713, stop.stop_requested());
    return static_cast<double>(std::clock() - before);
  };
  std::stop_source source;
  const double whole = seconds(source.get_token());
  source.request_stop();
  EXPECT_LT(seconds(source.get_token()) * 10, whole);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace merker::compilation
