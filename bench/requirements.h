// What the measurements must reach on a present-day PC.
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>

namespace merker::bench {

// Prints one line per measurement, with the required value beside it where there is one.
class RequirementReporter : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;
  bool allMet() const { return allMet_; }

 private:
  void report(const Run& run);
  void reportSize(double bytes);
  std::map<std::string, double> reached_;  // per second, by benchmark
  bool allMet_ = true;
};

}  // namespace merker::bench
