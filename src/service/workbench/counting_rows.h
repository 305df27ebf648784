// The masks of a counting channel as rows of an answer: what has a meaning in its mode (technology
// manual 5.3.2 to 5.3.5; CNT-PARAM-01 to -36).
#pragma once

#include "catalogue/counting.h"
#include "io/count_channel.h"
#include "project/settings_edit.h"
#include "workbench/json.h"

namespace merker::workbench {

// The keys are those of [[module.channel]] in merker.toml. `type`: of the CPU, which limits
// frequencies (CNT-OVW-03).
Json countingRows(const io::CountChannel& channel, const CountingType& type);

// Before `key` of a channel is set to a value (as TOML): what has no meaning beside that value
// leaves merker.toml. With another mode all others begin with their defaults.
void dropCounting(project::SettingsEdit& edit, const project::ModulePlace& place,
                  std::uint32_t number, std::string_view key, std::string_view value);

}  // namespace merker::workbench
