// Values over virtual time, sampled at the ends of cycles: each, or one in every so many
// milliseconds.
#pragma once

#include <algorithm>
#include <deque>
#include <string>
#include <variant>
#include <vector>

#include "io/rack.h"
#include "plant/plants.h"
#include "positioning/axis_values.h"
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
  // The rows since the last call as JSON, [[timeMs, v0, v1, …], …], as many as an event takes;
  // those that nobody fetched in time are lost. Empty: there are none.
  std::string takeRows(const Plc& plc, std::uint64_t program);
  std::size_t curves() const { return names_.size(); }
  // How many values may wait, of all rows and with their times.
  void limit(std::size_t values) { mostRows_ = std::min(kMostRows, values / (names_.size() + 1)); }

 private:
  // Some seconds of the fastest cycles for a browser that does not read meanwhile.
  static constexpr std::size_t kMostRows = 20'000;

  using Source = std::variant<std::monostate, address::Reference, plant::SignalPlace, io::Terminal,
                              const positioning::AxisValue*>;
  Json describe(const std::string& name, Source& source, const Plc& plc) const;
  static double value(const Source& source, const Plc& plc);

  std::vector<std::string> names_;
  std::vector<Source> sources_;
  Duration every_;
  Instant next_{INT64_MIN};
  std::uint64_t program_ = 0;
  std::size_t mostRows_ = kMostRows;
  // Rows behind each other: the time in ms, then the values; not a number: there is none.
  std::deque<double> rows_;
};

}  // namespace merker::workbench
