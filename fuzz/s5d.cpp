// S5D files: any bytes are read; what was read can be written and reads back with the same code.
// The last bit of the first byte chooses the code page.
#include "harness.h"
#include "s5d/program.h"
#include "step5/compiler.h"

using namespace merker;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const Encoding codePage = (data[0] & 1) != 0 ? Encoding::Cp850 : Encoding::Cp437;
  const s5d::Contents contents = s5d::readProgram({data + 1, size - 1}, codePage);
  (void)step5::listing(contents.program);
  (void)step5::listing(contents.deleted);
  const auto bytes = s5d::writeProgram(contents.program, contents.name, codePage);
  const s5d::Contents again = s5d::readProgram(bytes, codePage);
  fuzz::require(again.program.size() == contents.program.size(), "a program keeps its blocks");
  for (const auto& [id, block] : contents.program) {
    const mc5::Block& back = again.program.at(id);
    fuzz::require(back.words == block.words && back.formats == block.formats,
                  "a block keeps its words and formats");
  }
  return 0;
}
