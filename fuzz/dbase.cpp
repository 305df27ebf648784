// dBase: the first two bytes are the length of a table, its memo follows.
#include "s7p/dbase.h"

#include "harness.h"

using namespace merker;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const std::size_t length = std::min<std::size_t>(data[0] | data[1] << 8, size - 2);
  s7p::Table table(archive::fileOf({data + 2, data + 2 + length}));
  const s7p::Memo memo(archive::fileOf({data + 2 + length, data + size}));
  std::size_t rows = 0;
  while (table.next()) {
    ++rows;
    (void)table.text("NAME");
    const auto content = memo.read(table.numberOr("MEMO", 1), 1000);
    fuzz::require(!content || content->size() <= 1000, "a memo is cut to its length");
  }
  fuzz::require(rows <= length, "a row has at least a byte");
  return 0;
}
