// VERSION : 1.2 of a block header: two numbers of 4 bits (S7-SRC-02).
#pragma once

#include <cstdint>
#include <string_view>

namespace merker::step7 {

bool validVersion(std::string_view text);
// "1.2" as 16#12. Of an invalid text whatever its digits give.
std::uint8_t parseVersion(std::string_view text);

}  // namespace merker::step7
