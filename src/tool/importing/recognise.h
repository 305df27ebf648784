// What a file is, by its content; its name matters where two kinds look alike.
#pragma once

#include <string>
#include <string_view>

#include "archive/tree.h"

namespace merker::importing {

enum class Kind : std::uint8_t {
  Unknown,
  AwlSource,
  Containers,  // a block or a WLD file: containers one behind the other
  Hardware,    // HW Config export (*.cfg)
  Sdf,
  Asc,
  Dif,
  Seq,
  Assignments,  // a list of symbols of STEP 5, *Z0.SEQ
  Listing,      // blocks of STEP 5
  Damaged       // like one of the texts, but with bytes that no text has
};

// Looks at the beginning of the file. An assignment list of STEP 5 differs by its name only.
Kind recognise(const archive::File& file, std::string_view path);
// A file that Merker has in its own projects and that only its name tells: symbols, a scenario, a
// variable table, a stored state, a recording.
bool isOwnFile(std::string_view path, const archive::File& file);
// Of a text in a project: ".awl", ".sdf" and the like; empty for other kinds.
std::string_view extensionOf(Kind kind);

}  // namespace merker::importing
