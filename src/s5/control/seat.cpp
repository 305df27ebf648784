#include "control/seat.h"

#include <cstddef>
#include <type_traits>

namespace merker::cnc {

using sinumerik::Machine;

static_assert(std::is_standard_layout_v<Seat>);

std::uint32_t bytesBetween(const void* from, const void* to) {
  return static_cast<std::uint32_t>(static_cast<const std::byte*>(to) -
                                    static_cast<const std::byte*>(from));
}

namespace {

enum Note : std::size_t { Open, Number, Start, Length };  // sinumerik::OpenData

}  // namespace

#define DISPLAY(bit) static_cast<int>(offsetof(Seat, displays) + offsetof(sinumerik::Displays, bit))
#define FIELD(name) static_cast<int>(offsetof(Seat, name))
#define OPEN(name) static_cast<int>(offsetof(Seat, open) + offsetof(jit::OpenBlock, name))

jit::Layout layoutOf(const Machine& m) {
  const int none = FIELD(unused);
  return {.clock = FIELD(clock),
          .horizon = FIELD(horizon),
          .instructions = FIELD(instructions),
          .items = {FIELD(akku1), FIELD(akku2), none, none, none, none, DISPLAY(chain),
                    DISPLAY(vke), DISPLAY(status), DISPLAY(orBit), DISPLAY(os), DISPLAY(ov),
                    DISPLAY(anz0), DISPLAY(anz1), none},
          .image = FIELD(images),
          .images = {0, bytesBetween(&m.inputs, &m.outputs), bytesBetween(&m.inputs, &m.flags)},
          .data = {.begin = FIELD(open),
                   .data = OPEN(data),
                   .length = OPEN(readable),
                   .writable = OPEN(writable)},
          .instance = {.data = FIELD(cells), .length = none, .writable = none},
          .blocks = jit::Layout::Blocks{.top = FIELD(top),
                                        .first = FIELD(first),
                                        .last = FIELD(last),
                                        .sites = FIELD(sites),
                                        .dataBlocks = FIELD(dataBlocks)}};
}

#undef DISPLAY
#undef FIELD
#undef OPEN

// Data beyond the block can be read to the end of the segment (S5-DB-15), not written (OP-04).
jit::OpenBlock openBlock(Machine& m, const sinumerik::OpenData& data) {
  jit::OpenBlock open{.note = {data.open ? 1u : 0u, data.number, data.start, data.length}};
  auto& memory = m.blocks.data();
  if (!data.open || std::uint64_t{data.start} + data.length > memory.size()) return open;
  open.data = memory.data() + data.start;
  open.readable = static_cast<std::uint32_t>(2 * (memory.size() - data.start));
  open.writable = 2 * data.length;
  return open;
}

sinumerik::OpenData openData(const jit::OpenBlock& open) {
  const auto& note = open.note;
  return {note[Open] != 0, static_cast<std::uint16_t>(note[Number]), note[Start], note[Length]};
}

}  // namespace merker::cnc
