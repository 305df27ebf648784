// The plants of a station in operation. A value; time is an argument. A step takes the outputs of
// the modules as they are at its end (PID-SIM-01: outputs act on the next step), and the inputs
// change at that instant.
#pragma once

#include <memory>
#include <vector>

#include "io/rack.h"
#include "plant/configuration.h"

namespace merker::plant {

class Plants {
 public:
  explicit Plants(Configuration configuration);

  const Configuration& configuration() const { return configuration_; }
  Instant next() const { return next_; }  // of the first plant that moves
  void advance(io::Rack& rack, Instant now);

  // A scenario sets an input; the plant sees it at once.
  void set(io::Rack& rack, SignalPlace place, double value, Instant now);
  double value(SignalPlace place) const { return units_[place.plant].values[place.signal]; }

 private:
  struct Unit {
    std::unique_ptr<Process> process;
    std::vector<double> values;
    Instant at, nextStep = Instant::never();
    bool fresh = true;  // its outputs have not been shown yet
    Instant next() const;
  };
  void move(std::size_t index, io::Rack& rack, Instant to);
  void go(std::size_t index, io::Rack& rack, Instant to);
  void readInputs(std::size_t index, const io::Rack& rack);
  void showOutputs(std::size_t index, io::Rack& rack, Instant now) const;
  void findNext();

  Configuration configuration_;
  std::vector<Unit> units_;
  Instant next_;
};

}  // namespace merker::plant
