// A process that does some runs of a campaign, each in a process of its own: what breaks one of
// them breaks nothing else, and runs with the same beginning go on from where it ended.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "campaign/plan.h"
#include "campaign/wire.h"

namespace merker::app {

// A run without outcome: "needs more than 60 s of processor time ...".
struct LostRun {
  std::uint64_t number = 0;
  std::string why;
};
std::optional<LostRun> decodeLost(std::string_view line);
// Why a process ended that should have written an outcome; `status`: of waitpid.
std::string whyEnded(int status, const campaign::Definition& definition);

// Does the runs one after the other and writes a line for each to `out`. Ends the process; call it
// behind fork(). It dies with `parent`.
[[noreturn]] void doRuns(const campaign::Plan& plan, std::span<const std::uint64_t> numbers,
                         int out, int parent);

}  // namespace merker::app
