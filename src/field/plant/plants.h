// The plants of a station in operation. A value; time is an argument. A step takes the outputs of
// the modules as they are at its end (PID-SIM-01: outputs act on the next step), and the inputs
// change at that instant.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "io/rack.h"
#include "plant/configuration.h"

namespace merker::plant {

class Plants {
 public:
  explicit Plants(Configuration configuration);

  // What sensors show before time begins.
  void show(io::Rack& rack, Instant at);

  const Configuration& configuration() const { return configuration_; }
  Instant next() const { return next_; }  // of the first plant that moves
  void advance(io::Rack& rack, Instant now);
  // Up to before silentUntil(), quicker than step by step: the plants that nothing but levels at
  // terminals connects with others.
  void advanceAlone(io::Rack& rack, Instant now);
  // As long as nobody changes an output of a module or sets a signal: before this instant no
  // terminal shows another level, or `amounts` another amount where not only an access sees it
  // (Rack::onlyByAccess), although plants may move.
  Instant silentUntil(const io::Rack& rack, bool amounts) const;

  // A scenario sets an input; the plant sees it at once.
  void set(io::Rack& rack, SignalPlace place, double value, Instant now);
  // As it is seen from outside: of a stuck sensor what it is stuck at.
  double value(SignalPlace place) const;

  // A stuck sensor shows `value`, whatever the process does; a stuck actuator acts as if it had
  // `value`, whatever it is told. Without a value: the one it has now.
  void stick(io::Rack& rack, SignalPlace place, std::optional<double> value, Instant now);
  void release(io::Rack& rack, SignalPlace place, Instant now);
  std::optional<double> stuck(SignalPlace place) const;

  // Of a wire to another station (Configuration::far): what an input gets there, which its plant
  // sees at its next step; what an output shows there.
  void tell(std::uint32_t farWire, double value) { told_[farWire] = value; }
  double shows(std::uint32_t farWire) const;

  // As at the beginning: its process, its inputs, without faults.
  void reset(io::Rack& rack, std::uint32_t plant, Instant now);

 private:
  struct Stuck {
    std::uint32_t signal;
    double value;
    double told;  // to an input meanwhile
  };
  struct Unit {
    std::unique_ptr<Process> process;
    std::vector<double> values;  // as the process has them
    std::vector<Stuck> stuck;
    // By wires, outputs: terminals are set by changes.
    std::vector<std::optional<double>> shown;
    std::vector<std::shared_ptr<const signal::Signal>> courses;
    Instant at, nextStep = Instant::never();
    bool fresh = true;  // its outputs have not been shown yet
    Instant next{};     // when it moves; after each change: findNext()
    void findNext();
    const Stuck* stuckAt(std::uint32_t signal) const {
      return stuck.empty() ? nullptr : foundStuck(signal);
    }
    const Stuck* foundStuck(std::uint32_t signal) const;
  };
  void start(std::size_t index, Instant now);
  void move(std::size_t index, io::Rack& rack, Instant to);
  void go(std::size_t index, io::Rack& rack, Instant to);
  void readInputs(std::size_t index, const io::Rack& rack) {
    readInputs(index, rack, units_[index].values);
  }
  void readInputs(std::size_t index, const io::Rack& rack, std::vector<double>& values) const;
  Instant silentUntil(std::size_t index, const io::Rack& rack, bool amounts) const;
  // How a plant is wired.
  struct Wiring {
    bool switches = false;                // levels of its own at terminals
    std::vector<std::uint32_t> analog{};  // modules that get an amount from it
    bool fed = false, feeds = false;      // by another plant, another plant
    bool bus = false;                     // a drive behind a DP slave, a wire to another station
  };
  std::vector<Wiring> wirings() const;
  void stepSilently(std::size_t index, const io::Rack& rack, Instant to);
  void showOutputs(std::size_t index, io::Rack& rack, Instant now);
  void showOutput(std::size_t index, std::size_t wire, io::Rack& rack, Instant now);
  void answer(std::size_t index, std::size_t wire, const io::ProcessData& data, io::Rack& rack);
  void findNext();

  Configuration configuration_;
  std::vector<Wiring> wiring_;
  std::vector<Unit> units_;
  std::vector<double> told_;  // by number of the far wire
  Instant next_;
};

}  // namespace merker::plant
