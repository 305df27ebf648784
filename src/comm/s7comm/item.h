// What a variable job is about: items with an address each.
#pragma once

#include <optional>
#include <vector>

#include "s7comm/plc.h"
#include "s7comm/transport_size.h"

namespace merker::s7comm {

// As it stands in the request: "S7ANY", the address of one operand or of a row of them.
struct AnyItem {
  ElementType type = ElementType::Byte;
  std::uint16_t count = 1;
  std::uint16_t block = 0;
  Memory memory = Memory::Flag;
  std::uint32_t address = 0;  // byte * 8 + bit; of timers and counters their number
};

// What is to be read or written. One range; several of a DBREAD item, whose values are one value.
struct Wanted {
  ItemCode code = ItemCode::Done;  // else why it is refused
  std::vector<Range> ranges{};
  DataUnit unit = DataUnit::None;  // of the answer
  bool areas = false;              // a DBREAD item
  bool coded = false;              // each range has its own code in front of it
  std::uint32_t octets() const;
};

// Takes the next item off `bytes`, whatever its syntax. Nothing: it goes beyond them.
std::optional<Wanted> readItem(View& bytes);
// So many; behind one with an odd number of octets one fills up, but not behind the last. Nothing:
// they go beyond `bytes`.
std::optional<std::vector<Wanted>> readItems(View& bytes, std::size_t count);
void writeItem(Bytes& out, const AnyItem& item);

}  // namespace merker::s7comm
