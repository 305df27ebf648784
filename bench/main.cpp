#include <vector>

#include "reporter.h"

int main(int count, char** arguments) {
  // What is compared with each other is measured in turns: other work of the host slows both.
  char turns[] = "--benchmark_enable_random_interleaving=true";
  std::vector<char*> all(arguments, arguments + count);
  all.insert(all.begin() + 1, turns);
  count = static_cast<int>(all.size());
  all.push_back(nullptr);
  benchmark::Initialize(&count, all.data());
  if (benchmark::ReportUnrecognizedArguments(count, all.data())) return 2;
  merker::bench::Reporter reporter;
  const bool ran = benchmark::RunSpecifiedBenchmarks(&reporter) > 0;
  reporter.print();
  return ran && reporter.allMet() ? 0 : 1;
}
