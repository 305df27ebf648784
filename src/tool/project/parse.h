// A text in TOML as a table, within the limits of what people write by hand.
#pragma once

#include <optional>

#include "project/table.h"
#include "source/source_file.h"

namespace merker::project {

// Nothing, and a problem with its place, if it is none, has more than 1 MB or keys too deep.
std::optional<toml::table> parseToml(const source::SourceFile& file, Problems& problems);

}  // namespace merker::project
