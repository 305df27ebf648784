// What a plant can be: its parameters in merker.toml, its signals, and how it moves.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "clock/instant.h"
#include "signal/signal.h"

namespace merker::plant {

// A key of [[plant]]: a number, a whole number, true or false (1, 0), or a length of time, which
// then is in seconds.
struct Parameter {
  enum class Form : std::uint8_t { Number, Time, Whole, Flag };
  std::string_view key;  // "time_constant"
  Form form = Form::Number;
  double standard = 0, low = 0, high = 0;
};

// What is wired to terminals, set by scenarios (inputs) and looked at (both).
struct Signal {
  std::string_view name;  // "PV"
  enum class Side : std::uint8_t { Input, Output } side = Side::Input;
  bool binary = false;
  double rest = 0;  // of an input that nothing drives
  // Values at the rated ends of an analog range, unless the wiring says otherwise.
  double low = 0, high = 100;
  std::string_view unit = "";
};

// How a plant moves. `values` are those of all signals, in the order of its kind's row.
class Process {
 public:
  virtual ~Process() = default;
  // Outputs before the first step.
  virtual void begin(std::span<double> values) = 0;
  // On from one instant to a later one with these inputs; `to` = `from` when an input has just
  // been set.
  virtual void advance(Instant from, Instant to, std::span<double> values) = 0;
  // So many steps with the same inputs.
  virtual void advanceSteps(Instant from, Duration step, std::int64_t count,
                            std::span<double> values) {
    for (; count > 0; --count, from = from + step) advance(from, from + step, values);
  }
  // When outputs change by themselves, besides the steps of the plant.
  virtual Instant next() const { return Instant::never(); }
  // As long as its inputs stay as they are in `values`: not before so many seconds does a binary
  // output change, however often it moves. 0: nothing is known.
  virtual double silence(std::span<const double> /*values*/) const { return 0; }
  // A fast binary output as a function of time, the same object until it takes another course;
  // null: the value as it is.
  virtual std::shared_ptr<const signal::Signal> course(std::uint32_t) const { return nullptr; }
};

struct Telegram;  // telegram.h

struct Kind {
  std::string_view name;  // "first order"
  // Between two steps; zero: the process moves by its own instants and by changes of inputs only.
  Duration step;
  std::span<const Parameter> parameters;
  std::span<const Signal> signals;
  // `parameters` in the order of the row.
  std::unique_ptr<Process> (*make)(std::span<const double> parameters);
  // Of a drive that is wired to a bus: which words of the telegram are which of its signals.
  const Telegram* telegram = nullptr;
  // Some outputs are functions of time (Process::course), which no wire to another station carries.
  bool fast = false;

  std::optional<std::uint32_t> signal(std::string_view wanted) const;  // ignoring case
};

std::span<const Kind* const> kinds();
const Kind* findKind(std::string_view name);  // ignoring case
std::string kindNames();                      // for problems
std::string signalNames(const Kind& kind);

}  // namespace merker::plant
