// What a file is, by its content; its name does not matter.
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
  Damaged  // like one of the texts, but with bytes that no text has
};

// Looks at the beginning of the file.
Kind recognise(const archive::File& file);
// A file that Merker has in its own projects and that only its name tells: symbols, a scenario, a
// variable table, a stored state, a recording.
bool isOwnFile(std::string_view path, const archive::File& file);
// ".sdf" and the like; empty for other kinds.
std::string_view symbolExtension(Kind kind);

}  // namespace merker::importing
