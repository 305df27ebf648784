// STEP 7 projects: parts, each a byte for its file, its length in two bytes, and its bytes; what is
// found is read to the end.
#include <array>

#include "harness.h"
#include "s7p/catalogue.h"
#include "s7p/folder.h"
#include "s7p/sources.h"
#include "s7p/symbols.h"

using namespace merker;

namespace {

constexpr std::array<const char*, 10> kFiles{"hrs/S7RESOFF.DBF",
                                             "hrs/linkhrs.lnk",
                                             "Global/Language",
                                             "ombstx/offline/00000001/SUBBLK.DBF",
                                             "ombstx/offline/00000001/SUBBLK.DBT",
                                             "YDBs/1/SYMLIST.DBF",
                                             "s7asrcom/00000001/S7CONTAI.DBF",
                                             "YDBs/YLNKLIST.DBF",
                                             "hOmSave7/s7hstatx/HOBJECT1.DBF",
                                             "x.s7p"};

std::map<std::string, std::string> filesOf(const std::uint8_t* data, std::size_t size) {
  std::map<std::string, std::string> files;
  for (std::size_t at = 0; at + 3 <= size;) {
    const std::size_t length =
        std::min<std::size_t>(data[at + 1] | data[at + 2] << 8, size - at - 3);
    files[kFiles[data[at] % kFiles.size()]] = std::string(fuzz::text(data + at + 3, length));
    at += 3 + length;
  }
  return files;
}

void read(const archive::Tree& tree, const s7p::Project& project, const s7p::Program& program) {
  s7p::Faults faults;
  if (program.blocks) {
    s7p::Folder folder(tree, *program.blocks, project.page, faults);
    for (const BlockId id : folder.blocks())
      fuzz::require(folder.read(id).has_value(), "a listed block is read");
    (void)folder.variableTables();
  }
  if (!program.symbols.empty()) (void)s7p::readSymbols(tree, program.symbols, project.page, faults);
  if (!program.sources.empty()) (void)s7p::readSources(tree, program.sources, project.page, faults);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const archive::Tree tree(filesOf(data, size));
  s7p::Faults faults;
  for (const s7p::Project& project : s7p::findProjects(tree, faults))
    for (const s7p::Program& program : project.programs) read(tree, project, program);
  return 0;
}
