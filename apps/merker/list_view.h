// merker list PATH --view kop|fup [--svg FILE]
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "build.h"
#include "diagram/diagram.h"

namespace merker::app {

void printView(const Build& build, diagram::View view, Mnemonics mnemonics);
nlohmann::json viewToJson(const Build& build, diagram::View view, Mnemonics mnemonics);
// All networks as one picture. The exit code.
int writeView(const Build& build, diagram::View view, Mnemonics mnemonics, const std::string& path);

}  // namespace merker::app
