// Zips: any bytes are listed or refused, and every file of them can be read or is refused.
#include "archive/tree.h"
#include "harness.h"

using namespace merker;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  archive::Limits limits;
  limits.unpacked = 1u << 20;
  limits.unpackedInAll = 4u << 20;
  const archive::Tree tree(archive::fileOf({data, data + size}), limits);
  for (const auto& entry : tree.files()) {
    fuzz::require(tree.find(entry.path) != nullptr, "a listed file is found");
    fuzz::require(("/" + entry.path + "/").find("/../") == std::string::npos,
                  "no path leads out of the zip");
    if (const auto file = tree.open(entry))
      fuzz::require(file->text(1u << 20).size() <= limits.unpacked, "a file has its limit");
  }
  return 0;
}
