// Literal codes with the text they show in both mnemonics.
#pragma once

#include <span>
#include <string_view>

namespace merker::mc7 {

struct Vector {
  std::string_view code;  // hexadecimal
  std::string_view de, en;
};

// Decodes each code, compares both texts, encodes the instruction and expects the same code.
void checkVectors(std::span<const Vector> vectors);

}  // namespace merker::mc7
