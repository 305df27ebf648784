// S7-EDIT-22: the program structure, from the machine code.
#include "monitor/program_structure.h"

#include <gtest/gtest.h>

#include "plc.h"

namespace merker::monitor::test {
namespace {

std::string text(const BlockStructure& block) {
  std::string result = toString(block.id) + (block.local ? " " + std::to_string(*block.local) : "");
  for (const UsedBlock& used : block.uses) {
    result += "; " + toString(used.id);
    if (used.instance >= 0) result += ", DB " + std::to_string(used.instance);
  }
  return result;
}

std::vector<std::string> structure(const std::string& source) {
  const Plc plc(source);
  const block::Program library = system::library(defaultCpuModel());
  std::vector<std::string> texts;
  const auto references = crossReferences(plc.program(), plc.symbols(), {.library = &library});
  for (const BlockStructure& block : programStructure(plc.program(), references))
    texts.push_back(text(block));
  return texts;
}

const std::string kOneWord = "STRUCT\n a : WORD;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n";
const std::string kInstances =
    "DATA_BLOCK DB 1\n" + kOneWord + "DATA_BLOCK DB 2\n" + kOneWord + "DATA_BLOCK DB 3\n" +
    kOneWord +
    "FUNCTION_BLOCK FB 10\nVAR_INPUT\n in : INT;\n data : BLOCK_DB;\nEND_VAR\nVAR_TEMP\n t : "
    "ARRAY[1..3] OF BYTE;\nEND_VAR\nBEGIN\nNETWORK\n NOP 0;\nEND_FUNCTION_BLOCK\n"
    "DATA_BLOCK DB 11\nFB 10\nBEGIN\nEND_DATA_BLOCK\nDATA_BLOCK DB 12\nFB 10\nBEGIN\n"
    "END_DATA_BLOCK\n";

// An access with its block, a block that AUF opens, a parameter; instances stand at their calls.
TEST(ProgramStructure, NamesDataBlocksAndInstances) {
  EXPECT_EQ(
      structure(kInstances + "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n L DB1.DBW 0;\n AUF DB 2;\n"
                             " CALL FB 10, DB 11 (in := 1, data := DB 3);\n"
                             " CALL FB 10, DB 12 (in := 1, data := DB 3);\n"
                             " CALL FB 10, DB 11 (in := 2, data := DB 3);\nEND_FUNCTION\n")
          .front(),
      "FC 1 6; DB 1; DB 2; DB 3; FB 10, DB 11; FB 10, DB 12");
}

// An instance that is read beside its call is used itself.
TEST(ProgramStructure, AnInstanceThatIsReadIsUsed) {
  const auto list = structure(kInstances +
                              "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n"
                              " CALL FB 10, DB 11 (in := 1, data := DB 3);\n L DB11.DBW 0;\n"
                              "END_ORGANIZATION_BLOCK\n");
  EXPECT_EQ(list.front().substr(0, 5), "OB 1 ");
  EXPECT_NE(list.front().find("; DB 11; FB 10, DB 11"), std::string::npos) << list.front();
}

// Whole words; an OB has its start information even if it declares nothing.
TEST(ProgramStructure, LocalDataIsWhatTheCpuAllots) {
  EXPECT_EQ(structure("FUNCTION FC 1 : VOID\nVAR_TEMP\n a : INT;\n b : BYTE;\nEND_VAR\nBEGIN\n"
                      "NETWORK\n L #a;\nEND_FUNCTION\n"
                      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n UC FC 1;\n"
                      "END_ORGANIZATION_BLOCK\n"),
            (std::vector<std::string>{"OB 1 20; FC 1", "FC 1 4"}));
}

}  // namespace
}  // namespace merker::monitor::test
