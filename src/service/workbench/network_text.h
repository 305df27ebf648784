// The text of a request about networks.
#pragma once

#include "graph/language.h"
#include "networks/source_networks.h"
#include "workbench/elsewhere.h"

namespace merker::workbench {

// With what its words may refer to.
struct NetworkText {
  source::SourceFile file;
  networks::Surroundings around;
};

Result<NetworkText, Problems> networkText(const Aside& aside, const compilation::Build& build);
std::int64_t networkLine(const Fields& fields);
graph::Language networkLanguage(const Fields& fields);

}  // namespace merker::workbench
