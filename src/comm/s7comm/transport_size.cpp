#include "s7comm/transport_size.h"

#include <algorithm>
#include <iterator>

namespace merker::s7comm {
namespace {

using enum ElementType;

constexpr ElementRow kElements[] = {{Bit, 1, DataUnit::Bit},
                                    {Byte, 1, DataUnit::Byte},
                                    {Char, 1, DataUnit::Octets},
                                    {Word, 2, DataUnit::Byte},
                                    {Int, 2, DataUnit::Int},
                                    {DWord, 4, DataUnit::Byte},
                                    {DInt, 4, DataUnit::Int},
                                    {Real, 4, DataUnit::Real},
                                    {Date, 2, DataUnit::Byte},
                                    {TimeOfDay, 4, DataUnit::Byte},
                                    {Time, 4, DataUnit::Byte},
                                    {S5Time, 2, DataUnit::Byte},
                                    {DateAndTime, 8, DataUnit::Octets},
                                    {Counter, 2, DataUnit::Octets},
                                    {Timer, 2, DataUnit::Octets}};

}  // namespace

const ElementRow* findElement(std::uint8_t code) {
  const auto* const found =
      std::ranges::find(kElements, static_cast<ElementType>(code), &ElementRow::type);
  return found == std::end(kElements) ? nullptr : found;
}

}  // namespace merker::s7comm
