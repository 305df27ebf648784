// Text as it comes from disks: code pages in, UTF-8 inside (S7-SRC; sources are CP1252, CP437/850
// or UTF-8).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace merker {

enum class Encoding : std::uint8_t { Utf8, Cp1252, Cp850, Cp437, Utf16Le, Utf16Be, Binary };

// Guesses the encoding of a file. BOM first; valid UTF-8; else CP850/CP437 when the bytes above 7Fh
// are mostly those that are German letters there (81h, 84h, 8Eh, 94h, 99h, 9Ah, E1h) and hardly any
// that are in CP1252; else CP1252. NUL bytes or many control characters mean Binary.
Encoding detectEncoding(std::string_view bytes);

// UTF-8 without BOM; what has no counterpart becomes U+FFFD. Binary comes back as it is.
std::string toUtf8(std::string_view bytes, Encoding encoding);
// For STRING and CHAR data in a block: one CP1252 byte per character, '?' where there is none.
std::string toCp1252(std::string_view utf8);

std::string upper(std::string_view text);  // ASCII letters only
bool equalsIgnoreCase(std::string_view a, std::string_view b);
std::string_view trim(std::string_view text);
// Number of characters (code points) in UTF-8 text; columns of problems count these.
std::size_t characterCount(std::string_view utf8);

}  // namespace merker
