#include <string>

#include "reporter.h"

int main(int count, char** arguments) {
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  merker::bench::Reporter reporter;
  // First, because everything else is measured against it.
  benchmark::RunSpecifiedBenchmarks(&reporter, std::string(merker::bench::kLimit));
  const bool ran = benchmark::RunSpecifiedBenchmarks(&reporter) > 0;
  return ran && reporter.allMet() ? 0 : 1;
}
