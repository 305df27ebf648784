// Bytes of a block while it is written.
#pragma once

#include <cstdint>
#include <vector>

#include "s5d/kind.h"

namespace merker::s5d {

void setWord(std::vector<std::uint8_t>& bytes, std::size_t at, std::uint32_t value);
void setLittle(std::vector<std::uint8_t>& bytes, std::size_t at, std::uint32_t value);
void addWord(std::vector<std::uint8_t>& bytes, std::uint32_t value);

// Fills in the head of a block whose bytes are complete: mark, number, library, length.
void putHead(std::vector<std::uint8_t>& bytes, const Kind& kind, std::uint16_t number,
             std::uint32_t library);

}  // namespace merker::s5d
