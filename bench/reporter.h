// Two tables: what is measured once, and what runs with both engines; the required value beside
// each figure. A slower machine than that of the requirements need not reach absolute values, but
// their share of its speed; ratios it must reach.
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "requirements.h"

namespace merker::bench {

class Reporter : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& /*context*/) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override;
  // The tables, after the last run.
  void print();
  bool allMet() const { return allMet_; }

 private:
  void report(const Run& run);
  void single(const Single& row, double measured);
  void pair(const Pair& row, double interpreted, double compiled);
  void further(const std::string& name, const Run& run);
  double reached(std::string_view benchmark) const;  // 0: not measured
  void header(const std::string& text);
  // Of this machine, of that for which absolute values are required; at most 1.
  double speed() const;
  std::string verdict(bool met, bool metForItsSpeed);

  std::map<std::string, double> reached_;  // by benchmark
  std::string header_;
  bool allMet_ = true;
};

}  // namespace merker::bench
