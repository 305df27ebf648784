// The results of a campaign for others: CSV for spreadsheets and Python, JUnit for CI servers. In
// the order of the runs, whoever ran them and when.
#pragma once

#include <iosfwd>
#include <optional>

#include "campaign/plan.h"
#include "campaign/results.h"

namespace merker::campaign {

// Runs and what is known of them.
struct Summary {
  std::uint64_t passed = 0, failed = 0, missing = 0;
};
// Calls `take(choice, id, outcome)` for each run that is over, of this shard.
template <typename Take>
Result<Summary> eachOutcome(const Plan& plan, const Shard& shard, Results& results, Take take) {
  Summary summary;
  const std::uint64_t runs = plan.definition().runs();
  for (std::uint64_t number = shard.number - 1; number < runs; number += shard.count) {
    const Choice choice = plan.choice(number);
    const std::string id = plan.id(choice);
    auto outcome = results.find(id);
    if (!outcome) return outcome.error();
    if (!outcome.value()) {
      ++summary.missing;
      continue;
    }
    ++(outcome.value()->passed ? summary.passed : summary.failed);
    take(choice, id, *outcome.value());
  }
  return summary;
}

// A header, then a line a run: run,id,PARAMETERS,seed,passed,message,seconds,cycles,MEASURES.
std::optional<Problem> writeCsv(const Plan& plan, const Shard& shard, Results& results,
                                std::ostream& out);
// A test case a run.
std::optional<Problem> writeJunit(const Plan& plan, const Shard& shard, Results& results,
                                  std::ostream& out);

}  // namespace merker::campaign
