// break MPI(1), break MPI(1) at Belt, short MPI(1), delay MPI(1) 5ms, mend MPI(1): faults of a
// subnet's line (S7-NET-01), for a project of several stations.
#pragma once

#include <optional>
#include <string>

#include "scenario/steps/bare.h"

namespace merker::network {
class Network;
class Subnet;
}  // namespace merker::network

namespace merker::simulator::steps {

struct OfLine {
  std::string subnet, station;  // station: empty: the whole line
  Position subnetAt, stationAt;

  // Name and `at STATION`; what is left of the line. Nothing, and a problem, without a name.
  std::optional<std::string_view> parseLine(const StepLine& line, bool ofOne);
  void resolve(const StepBinding& binding);

 protected:
  network::Subnet* find(StepRun& run) const;
  // Of the station; nothing: the whole line.
  std::optional<std::uint8_t> address(StepRun& run) const;
};

struct Break : OfLine {
  static constexpr std::string_view kWords = "break";
  bool parse(const StepLine& line);
  bool perform(StepRun& run) const;
};

struct Short : OfLine {
  static constexpr std::string_view kWords = "short";
  bool parse(const StepLine& line);
  bool perform(StepRun& run) const;
};

struct Delay : OfLine {
  static constexpr std::string_view kWords = "delay";
  Duration time;
  bool parse(const StepLine& line);
  bool perform(StepRun& run) const;
};

struct Mend : OfLine {
  static constexpr std::string_view kWords = "mend";
  bool parse(const StepLine& line);
  bool perform(StepRun& run) const;
};

}  // namespace merker::simulator::steps
