// merker list PATH --view kop|fup [--svg FILE], in the mnemonics of each block if none are given
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "build.h"
#include "diagram/diagram.h"

namespace merker::app {

void printView(const Build& build, diagram::View view, const diagram::Options& options);
nlohmann::json viewToJson(const Build& build, diagram::View view, const diagram::Options& options);
// All networks as one picture. The exit code.
int writeView(const Build& build, diagram::View view, const diagram::Options& options,
              const std::string& path);

}  // namespace merker::app
