#include "cnc/seat.h"

#include <cstddef>
#include <type_traits>

namespace merker::cnc {

using sinumerik::Machine;

static_assert(std::is_standard_layout_v<Seat>);

std::uint32_t bytesBetween(const void* from, const void* to) {
  return static_cast<std::uint32_t>(static_cast<const std::byte*>(to) -
                                    static_cast<const std::byte*>(from));
}

#define DISPLAY(bit) static_cast<int>(offsetof(Seat, displays) + offsetof(sinumerik::Displays, bit))
#define FIELD(name) static_cast<int>(offsetof(Seat, name))

jit::Layout layoutOf(const Machine& m) {
  const int none = FIELD(unused);
  return {.clock = FIELD(clock),
          .horizon = FIELD(horizon),
          .image = FIELD(images),
          .instructions = FIELD(instructions),
          .items = {FIELD(akku1), FIELD(akku2), none, none, none, none, DISPLAY(chain),
                    DISPLAY(vke), DISPLAY(status), DISPLAY(orBit), DISPLAY(os), DISPLAY(ov),
                    DISPLAY(anz0), DISPLAY(anz1), none},
          .images = {0, bytesBetween(&m.inputs, &m.outputs), bytesBetween(&m.inputs, &m.flags)},
          .data = {FIELD(data), FIELD(readable), FIELD(writable)},
          .instance = {FIELD(cells), none, none}};
}

#undef DISPLAY
#undef FIELD

// Data beyond the block can be read to the end of the segment (S5-DB-15), not written (OP-04).
void takeData(Seat& seat, Machine& m) {
  const sinumerik::OpenData& open = m.frame().data;
  auto& memory = m.blocks.data();
  seat.data = nullptr;
  seat.readable = seat.writable = 0;
  if (!open.open || std::uint64_t{open.start} + open.length > memory.size()) return;
  seat.data = memory.data() + open.start;
  seat.readable = static_cast<std::uint32_t>(2 * (memory.size() - open.start));
  seat.writable = 2 * open.length;
}

}  // namespace merker::cnc
