// Values over virtual time, sampled at the ends of cycles: each, or one in every so many
// milliseconds.
#pragma once

#include <deque>
#include <string>
#include <variant>
#include <vector>

#include "io/rack.h"
#include "plant/plants.h"
#include "workbench/json.h"
#include "workbench/plc.h"

namespace merker::workbench {

class Trend {
 public:
  Trend(std::vector<std::string> names, std::int64_t everyMs)
      : names_(std::move(names)), every_(Duration::milliseconds(everyMs)) {}

  // Binds the names to the program; what each is, or its problem.
  Json describe(const Plc& plc);
  // At the end of a cycle.
  void sample(const Plc& plc);
  // The rows since the last call, [timeMs, v0, v1, …]; those that nobody fetched in time are lost.
  Json takeRows(const Plc& plc, std::uint64_t program);

 private:
  struct Row {
    Instant time;
    std::vector<double> values;  // not a number: there is none
  };
  using Source = std::variant<std::monostate, mc7::Reference, plant::SignalPlace, io::Terminal>;
  Json describe(const std::string& name, Source& source, const Plc& plc) const;
  static double value(const Source& source, const Plc& plc);

  std::vector<std::string> names_;
  std::vector<Source> sources_;
  Duration every_;
  Instant next_{INT64_MIN};
  std::uint64_t program_ = 0;
  std::deque<Row> rows_;
};

}  // namespace merker::workbench
