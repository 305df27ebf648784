// What can be set on a module or the CPU, as rows of an answer: key of merker.toml, kind, value,
// what is possible (S7-HWCFG-03, -08, -09).
#pragma once

#include "project/project.h"
#include "workbench/json.h"

namespace merker::workbench {

Json parameterRows(const io::Module& module);
// [{side, number, parameters}] of analog channels, and of counting ones (side "number"), of which
// the CPU has as many as its model says.
Json channelRows(const io::Module& module, const CpuModel& model);
// [{table: "cpu", parameters}, {table: "cpu.OB35", ...}]
Json cpuParameterRows(const project::Project& project);

}  // namespace merker::workbench
