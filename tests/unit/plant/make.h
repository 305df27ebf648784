// Plants for tests, wired to the CPU's own inputs and outputs.
#pragma once

#include <string_view>
#include <vector>

#include "plant/plants.h"

namespace merker::plant {

struct Given {
  std::string_view key;
  double value;
};

io::Configuration onBoard();  // of a 314C-2 PtP; its analog range is ±10V
PlantSettings make(std::string_view name, std::string_view kind, std::vector<Given> given = {});
void wire(PlantSettings& plant, std::string_view signal, io::Terminal terminal, double scale = 1);

// One plant without wires.
class Bench {
 public:
  explicit Bench(PlantSettings settings)
      : rack_(onBoard()), plants_(Configuration{{std::move(settings)}}) {
    go(Instant{});
  }
  void set(std::string_view signal, double value) {
    plants_.set(rack_, place(signal), value, now_);
  }
  double value(std::string_view signal) const { return plants_.value(place(signal)); }
  void go(Instant to) { plants_.advance(rack_, now_ = to); }
  void wait(Duration time) { go(now_ + time); }
  Plants& plants() { return plants_; }

 private:
  SignalPlace place(std::string_view signal) const {
    return {0, plants_.configuration().plants[0].kind->signal(signal).value()};
  }
  io::Rack rack_;
  Plants plants_;
  Instant now_;
};

constexpr Instant at(std::int64_t ms) { return Instant{ms * 1'000'000}; }

}  // namespace merker::plant
