// Constants as the programmer's screen shows them: KH 1234, KF -5, KT 10.2, KG +1234567+02 …
// (S5-NUM-05 … -11, S5-LOAD-02).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "mc5/operand.h"

namespace merker::mc5 {

struct ConstantFormat {
  Format format;
  std::string_view word;    // "KH"
  std::uint8_t formatByte;  // second byte of `L Kx` (OP-46); 0 for those that have none
  std::string_view range;   // for problems: "0..FFFF, up to four hexadecimal digits"
};

const ConstantFormat& info(Format format);  // not Format::Other
const ConstantFormat* findConstantFormat(std::string_view word);

// "KF -5". Bits that the format cannot show print as format byte and hexadecimal number, "K#04 …",
// which reads back as the same bits.
std::string constantText(const Operand& constant);

// The bits of the text behind the format word, without blanks at its ends; nothing if it is not of
// this format.
std::optional<std::uint32_t> constantBits(Format format, std::string_view text);

}  // namespace merker::mc5
