// Block containers: any bytes are read or refused; a block that was read can be written and read
// again.
#include "block/container.h"

#include "harness.h"

using namespace merker;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto block = block::readContainer({data, size}, {});
  if (!block) return 0;
  const auto bytes = block::writeContainer(*block);
  const auto again = block::readContainer(bytes, {});
  fuzz::require(again.has_value(), "a container reads back");
  fuzz::require(again->id == block->id && again->code == block->code &&
                    again->actualData == block->actualData,
                "a container keeps its block");
  return 0;
}
