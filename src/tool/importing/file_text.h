// The text of one file as UTF-8, with what the report says about its characters.
#pragma once

#include <optional>
#include <string>

#include "base/code_page.h"
#include "importing/report.h"

namespace merker::importing {

// Blanks in place of a few zero bytes; those at the end, which fill a sector, are taken off. A file
// with many stays as it is: it is no text.
std::string withoutZeros(std::string bytes);
// The page of what is not Unicode.
struct Page {
  unsigned named = 0;  // by the user; 0: by the content
  PageGuess common;    // of all files together, for a file that does not tell it for certain
};
// Nothing if it is no text.
std::optional<std::string> readText(const std::string& path, std::string bytes, const Page& page,
                                    Report& report);

}  // namespace merker::importing
