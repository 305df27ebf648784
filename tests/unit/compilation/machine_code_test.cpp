// Blocks as machine code beside sources (docs/formats/project.md).
#include <gtest/gtest.h>

#include "../project/folder.h"
#include "block/container.h"
#include "compilation/build.h"

namespace merker::compilation {
namespace {

std::string containerOf(const std::string& text, BlockId id) {
  const auto program = step7::compile({source::SourceFile("x.awl", text)}, {}).program;
  const auto bytes = block::writeContainer(program.at(id));
  return {bytes.begin(), bytes.end()};
}

const std::string kAdder =
    "FUNCTION FC 1 : INT\nVAR_INPUT\nX : INT;\nEND_VAR\nBEGIN\nL #X;\nL 1;\n+I;\nT "
    "#RET_VAL;\nEND_FUNCTION\n";
const std::string kEmpty =
    "FUNCTION FC 1 : INT\nVAR_INPUT\nX : INT;\nEND_VAR\nBEGIN\nEND_FUNCTION\n";
const std::string kCaller =
    "ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 1 (X := 5, RET_VAL := MW "
    "10);\nEND_ORGANIZATION_BLOCK\n";

Build built(const project::Folder& folder) {
  return build(project::load(folder.path(), ""), false);
}

TEST(MachineCode, takesTheNamesOfItsDeclaration) {
  const project::Folder folder;
  folder.write("merker.toml");
  folder.write("FC1.mc7", containerOf(kAdder, {BlockKind::FC, 1}));
  folder.write("FC1.awl", kEmpty);
  folder.write("OB1.awl", kCaller);
  const Build build = built(folder);
  ASSERT_TRUE(build.ok()) << build.problems.list().front().message;
  const block::Block& fc = build.program->at({BlockKind::FC, 1});
  EXPECT_EQ(fc.variables.at(0).name, "X");
  EXPECT_EQ(fc.code.size(), step7::compile({source::SourceFile("x.awl", kAdder)}, {})
                                .program.at({BlockKind::FC, 1})
                                .code.size());
}

TEST(MachineCode, withoutDeclarationSourcesCallItByThePlacesOfItsVariables) {
  const project::Folder folder;
  folder.write("merker.toml");
  folder.write("a.mc7", containerOf(kAdder, {BlockKind::FC, 1}));
  folder.write("OB1.awl",
               "ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FC 1 (IN0 := 5, RET_VAL := MW 10);\n"
               "END_ORGANIZATION_BLOCK\n");
  const Build build = built(folder);
  ASSERT_TRUE(build.ok()) << build.problems.list().front().message;
  EXPECT_EQ(build.program->count({BlockKind::FC, 1}), 1u);
}

TEST(MachineCode, whatDoesNotFitIsAProblem) {
  const project::Folder folder;
  folder.write("merker.toml");
  folder.write("OB1.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\nEND_ORGANIZATION_BLOCK\n");
  const std::string good = containerOf(kAdder, {BlockKind::FC, 1});
  folder.write("a.mc7", "text");
  EXPECT_EQ(built(folder).problems.list().at(0).code, ProblemCode::P0601);
  folder.write("a.mc7", good.substr(0, good.size() - 1));
  EXPECT_EQ(built(folder).problems.list().at(0).code, ProblemCode::P0602);
  folder.write("a.mc7");
  EXPECT_EQ(built(folder).problems.list().at(0).code, ProblemCode::P0601);
  folder.write("a.mc7", good);
  folder.write("FC1.awl",
               "FUNCTION FC 1 : INT\nVAR_INPUT\nX : REAL;\nEND_VAR\nBEGIN\nEND_FUNCTION\n");
  EXPECT_EQ(built(folder).problems.list().at(0).code, ProblemCode::P0602);
}

}  // namespace
}  // namespace merker::compilation
