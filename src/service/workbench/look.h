// A program as it is compared with another one: its blocks as text, its symbols, its modules.
#pragma once

#include "workbench/json.h"
#include "workbench/offline.h"
#include "workbench/plc.h"

namespace merker::workbench {

// `program`: null, the one that was built; else that of the CPU, whose sources are those of
// `build`.
Json lookOf(const compilation::Build& build, const block::Program* program, Mnemonics mnemonics);

}  // namespace merker::workbench
