// What the monitor shows, as text for a terminal and as JSON: used by `merker debug` and `diag`.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "monitor/monitor.h"

namespace merker::app {

// "AKKU1 DW#16#00000005  AKKU2 …", "VKE 1  STA 1 …", open data blocks: several lines.
std::string registersText(const monitor::Registers& registers);
std::string blockStackText(const monitor::Stacks& stacks);
std::string interruptStackText(const monitor::Stacks& stacks);
std::string localStackText(const monitor::Stacks& stacks);
// The newest `count` entries.
std::string diagnosticsText(const std::vector<monitor::DiagnosticLine>& lines, std::size_t count);
std::string informationText(const monitor::ModuleInformation& information);

nlohmann::ordered_json toJson(const monitor::Stacks& stacks);
nlohmann::ordered_json toJson(const std::vector<monitor::DiagnosticLine>& lines);
nlohmann::ordered_json toJson(const monitor::ModuleInformation& information);
nlohmann::ordered_json toJson(const monitor::SourcePlace& place);

}  // namespace merker::app
