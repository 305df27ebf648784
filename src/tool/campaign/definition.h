// What the TOML file of a campaign says (docs/formats/campaign.md), before it is bound to a
// project.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/problem.h"
#include "check/check.h"
#include "clock/instant.h"
#include "source/source_file.h"

namespace merker::campaign {

// Bounds of what a file can ask for.
constexpr std::uint64_t kMostRuns = 1'000'000;
constexpr std::size_t kMostParameters = 16, kMostMeasures = 64, kMostValues = 10'000;
constexpr std::size_t kLongestName = 64;
constexpr double kLargestNumber = 1e15;

// Of a parameter: a text, which may be a number.
struct Value {
  std::string text;
  std::optional<double> number;
  bool operator==(const Value&) const = default;
};
Value valueOf(double number);

// A value drawn anew for each seed: evenly between `a` and `b`, or normal with mean `a` and
// standard deviation `b`.
struct Draw {
  enum class Kind : std::uint8_t { Uniform, Normal } kind = Kind::Uniform;
  double a = 0, b = 0;
};

// A line of [campaign.vary].
struct Parameter {
  std::string name;  // "plant.Vessel.stroke", as written
  Position position;
  struct Listed {
    Value value;
    Position position;
  };
  std::vector<Listed> values;  // one after the other; empty: drawn
  std::optional<Draw> draw;
};

// A line of [campaign.measure], with that of [campaign.require] of the same name.
struct MeasureText {
  std::string name, text;
  Position position;
  struct Requirement {
    block::Relation relation;
    double value;
    std::string text;  // "<= 95"
  };
  std::optional<Requirement> required;
};

struct ScenarioText {
  std::string file, name;  // as written; empty: none, the first of the file
  Position position;
};

struct Definition {
  std::string file, folder, name, project;
  Position projectPosition;
  std::optional<ScenarioText> scenario;
  std::optional<Duration> time, start;  // `for`; what all runs have in common
  std::uint64_t repeat = 0;             // seeds; 0: one run without a seed for each choice
  std::uint64_t firstSeed = 1;
  Duration timeLimit = Duration::seconds(60);  // of the processor, for one run
  std::uint32_t memoryLimit = 1024;            // MB, the same
  std::vector<Parameter> parameters;
  std::vector<MeasureText> measures;

  std::uint64_t runs() const;  // at most kMostRuns if there were no problems
};

Definition readDefinition(const source::SourceFile& file, Problems& problems);

}  // namespace merker::campaign
