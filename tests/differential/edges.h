// Numbers at which an instruction begins to do something else.
#pragma once

#include <cstdint>

namespace merker::differential {

constexpr std::uint32_t kEdges[] = {
    0,          1,          0xFFFFFFFF,              // -1
    0x7FFF,     0x8000,     0x7FFFFFFF, 0x80000000,  // ends of INT and DINT
    999,        1000,       0xFFFFFC19, 0xFFFFFC18,  // of three decimal digits (ITB)
    9'999'999,  10'000'000, 0xFF676981, 0xFF676980,  // of seven (DTB)
    0x0999,     0xF999,     0x09999999, 0xF9999999,  // the same as BCD (BTI, BTD)
    0x3F000000, 0x3FC00000, 0x40200000, 0x4F000000,
    0x7F7FFFFF,  // 0.5, 1.5, 2.5, 2^31, largest REAL
};

}  // namespace merker::differential
