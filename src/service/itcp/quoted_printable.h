// Texts of any characters in e-mails that carry ASCII.
#pragma once

#include <string>
#include <string_view>

namespace merker::itcp {

// Printable ASCII in lines that no mail server breaks.
bool isPlainText(std::string_view text);
// RFC 2045, 6.7: lines of at most 76 characters, which end with CR LF as those of `text` do.
std::string quotedPrintable(std::string_view text);
// UTF-8 as words of a header, RFC 2047, 4.2; as it is where it is printable ASCII.
std::string encodedWords(std::string_view text);

}  // namespace merker::itcp
