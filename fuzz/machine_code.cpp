// MC7 code: any bytes can be listed, every instruction in them codes back to its bytes, and a CPU
// survives them as OB 1.
#include <algorithm>

#include "harness.h"
#include "mc7/disassembly.h"
#include "mc7/instruction.h"
#include "station/station.h"

using namespace merker;

namespace {

void decodeAndEncode(std::span<const std::uint8_t> code) {
  for (std::size_t i = 0; i + 2 <= code.size(); i += 2) {
    const auto decoded = mc7::decode(code.subspan(i));
    if (!decoded) continue;
    std::vector<std::uint8_t> bytes;
    const bool coded = mc7::encode(*decoded->encoding, decoded->instruction.operand, bytes);
    fuzz::require(coded && std::equal(bytes.begin(), bytes.end(),
                                      code.begin() + static_cast<std::ptrdiff_t>(i)),
                  "an instruction codes back to its bytes");
  }
}

block::Block blockOf(BlockId id, std::span<const std::uint8_t> code) {
  block::Block block;
  block.id = id;
  block.code.assign(code.begin(), code.end());
  block.localBytes = 64;
  return block;
}

// OB 1 and FC 1 are halves of the code; DB 1 and DB 2 are there to be opened.
block::Program programOf(std::span<const std::uint8_t> code) {
  block::Program program;
  const std::size_t half = code.size() / 4 * 2;
  for (const BlockId id : {BlockId{BlockKind::OB, 1}, BlockId{BlockKind::FC, 1}})
    program[id] = blockOf(id, id.kind == BlockKind::OB ? code.subspan(half) : code.first(half));
  for (const std::uint16_t number : {std::uint16_t{1}, std::uint16_t{2}}) {
    block::Block data = blockOf({BlockKind::DB, number}, {});
    data.initialData.assign(32, 0);
    data.actualData.assign(32, 0);
    program[data.id] = data;
  }
  return program;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span code(data, size);
  for (const Mnemonics mnemonics : {Mnemonics::German, Mnemonics::International})
    for (const mc7::Line& line : mc7::disassemble(code, mnemonics)) (void)mc7::toString(line);
  decodeAndEncode(code);

  station::Options options;
  options.program = std::make_shared<block::Program>(programOf(code.first(size / 2 * 2)));
  station::Station station(std::move(options));
  station.warmRestart();
  station.advanceTo(Instant{} + Duration{20'000'000});
  return 0;
}
