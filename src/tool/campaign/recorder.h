// Measures while they are taken: looked at at the end of each cycle, as a trace.
#pragma once

#include <optional>
#include <vector>

#include "campaign/measure.h"
#include "campaign/sum.h"
#include "plc/controller.h"

namespace merker::campaign {

class Recorder {
 public:
  // From now on. `measures` and `plc` must outlive it.
  Recorder(const std::vector<Measure>& measures, const controller::Controller& plc);
  void sample();
  // One for each measure; nothing where there was nothing to measure.
  std::vector<std::optional<double>> results();

 private:
  struct Taken {
    std::optional<double> value;  // at the last look
    std::optional<double> extreme;
    double first = 0;             // value that there was
    Sum integral, away;           // value, and value less `first`, times seconds
    Duration time{}, held{};      // with a value; Time
    std::optional<double> since;  // When
    std::uint64_t count = 0;
  };
  void look(const Measure& measure, Taken& taken, Duration elapsed) const;
  std::optional<double> valueOf(const Measure& measure) const;
  static std::optional<double> meanOf(const Taken& taken);
  std::optional<double> result(const Measure& measure, const Taken& taken) const;

  const std::vector<Measure>& measures_;
  const controller::Controller& plc_;
  std::vector<Taken> taken_;
  Instant begin_, last_;
  std::uint64_t cycles_, instructions_;
};

}  // namespace merker::campaign
