// The zip of a project: what is not in it is named, and no single file makes it impossible.

#include "workbench/packing.h"

#include "archive/tree.h"
#include "transfer.h"

namespace merker::workbench::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> filesOf(const std::string& zip) {
  const archive::Tree tree(archive::fileOf({zip.begin(), zip.end()}));
  std::vector<std::string> names;
  for (const auto& entry : tree.files()) names.push_back(entry.path);
  return names;
}

const std::vector<std::string> kOwn = {"main.awl", "main.sym", "merker.toml"};

// Somebody moved it away while it was open.
TEST_F(Transfer, OfAProjectThatIsGoneThereIsNothing) {
  const std::string folder = bench.folder.path(), away = workspace.path("away");
  fs::rename(folder, away);
  EXPECT_EQ(bench.problem("projects.copy", {{"name", "copy"}}), "P0101");
  for (const char* method : {"download.begin", "files.list", "symbols.read"})
    EXPECT_EQ(bench.problem(method), "P0101") << method;
  EXPECT_FALSE(fs::exists(workspace.path("copy")));
  fs::rename(away, folder);
  bench.call("files.list");
}

TEST_F(Transfer, WhatIsNotInTheZipIsNamed) {
  bench.folder.write("lib/merker.toml", "[project]\nname = \"Lib\"\n");
  bench.folder.write("lib/main.awl", kMotorSource);
  bench.folder.write("back\\slash.txt", "x");
  bench.folder.write("new\nline.txt", "x");
  bench.folder.write("a:b/file.txt", "x");
  bench.folder.write("x.bak", "x");
  bench.folder.write(".hidden", "x");
  fs::create_symlink("/etc/passwd", bench.folder.path("link.awl"));
  fs::create_directory_symlink("/etc", bench.folder.path("etc"));
  EXPECT_EQ(bench.call("download.begin")["left"], Json({"a:b/", "back\\slash.txt", "etc", "lib/",
                                                        "link.awl", "new\\x0Aline.txt", "x.bak"}));
  EXPECT_EQ(filesOf(download()), kOwn);
}

TEST_F(Transfer, ANameThatIsNotUtf8CostsItself) {
  bench.folder.write("caf\xE9.txt", "x");
  EXPECT_EQ(bench.call("download.begin")["left"], Json({"caf\\xE9.txt"}));
  EXPECT_EQ(filesOf(download()), kOwn);
}

TEST_F(Transfer, AFileThatVanishesIsLeftOut) {
  for (const char* name : {"a.txt", "b.txt", "z.txt"}) bench.folder.write(name, "x");
  const ProjectFolder folder(bench.folder.path());
  Choice choice = choose(folder);
  fs::remove(bench.folder.path("b.txt"));
  fs::remove(bench.folder.path("z.txt"));
  const Packing made = pack(folder, std::move(choice), {});
  ASSERT_FALSE(made.wrong);
  EXPECT_EQ(made.result["left"], Json({"b.txt", "z.txt"}));
  EXPECT_EQ(made.result["files"], 4);
}

TEST_F(Transfer, TooManyFilesAreNoZipOfAPart) {
  for (int i = 0; i <= 20'000; ++i) bench.folder.write("many/f" + std::to_string(i), "");
  EXPECT_EQ(bench.problem("download.begin"), "P1308");
}

}  // namespace
}  // namespace merker::workbench::test
