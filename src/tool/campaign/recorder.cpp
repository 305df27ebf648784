#include "campaign/recorder.h"

#include <algorithm>
#include <cmath>

#include "check/relation.h"
#include "plant/field.h"
#include "positioning/axis_values.h"
#include "scenario/display.h"

namespace merker::campaign {
namespace {

using Kind = Measure::Kind;

double secondsOf(Duration time) { return static_cast<double>(time.ns) / 1e9; }

std::optional<double> operandValue(const address::Reference& operand,
                                   const controller::Controller& plc) {
  const auto bits = plc.read(operand);
  if (!bits) return std::nullopt;
  if (operand.operand.width == Width::Bit) return *bits != 0;
  return std::visit([](auto value) { return static_cast<double>(value); },
                    simulator::numericValue(operand, *bits));
}

bool holds(const Measure& measure, double value) {
  return block::relates(value, measure.relation, measure.limit) ||
         (measure.relation == block::Relation::About && block::about(value, measure.limit));
}

}  // namespace

Recorder::Recorder(const std::vector<Measure>& measures, const controller::Controller& plc)
    : measures_(measures),
      plc_(plc),
      taken_(measures.size()),
      begin_(plc.now()),
      last_(plc.now()),
      cycles_(plc.cycles()),
      instructions_(plc.instructions()) {
  for (std::size_t i = 0; i < measures_.size(); ++i) look(measures_[i], taken_[i], Duration{});
}

std::optional<double> Recorder::valueOf(const Measure& measure) const {
  const simulator::Watched& source = measure.source;
  std::optional<double> value;
  if (!source.operands.empty()) value = operandValue(source.operands.front(), plc_);
  if (!source.plants.empty())
    value =
        controller::capability<plant::Field>(plc_)->plants()->value(source.plants.front().place);
  if (!source.terminals.empty())
    value = simulator::presentValue(source.terminals.front(),
                                    *controller::capability<plant::Field>(plc_)->rack());
  if (!source.axis.empty())
    value =
        static_cast<double>(positioning::read(*source.axis.front().what, simulator::axisOf(plc_)));
  if (!value || !std::isfinite(*value)) return std::nullopt;
  return measure.amount ? std::abs(*value) : *value;
}

// `elapsed`: since the last look, in which the value was as it was seen then.
void Recorder::look(const Measure& measure, Taken& taken, Duration elapsed) const {
  if (taken.value) {
    taken.integral.add(*taken.value * secondsOf(elapsed));
    taken.away.add((*taken.value - taken.first) * secondsOf(elapsed));
    taken.time = taken.time + elapsed;
    if (holds(measure, *taken.value)) taken.held = taken.held + elapsed;
  }
  const auto value = valueOf(measure);
  if (value && !taken.extreme) taken.first = *value;
  if (value && taken.value) {
    taken.count += measure.kind == Kind::Changes && *value != *taken.value;
    taken.count += measure.kind == Kind::Rising && *taken.value == 0 && *value != 0;
    taken.count += measure.kind == Kind::Falling && *taken.value != 0 && *value == 0;
  }
  if (value) {
    const double before = taken.extreme.value_or(*value);
    taken.extreme = measure.kind == Kind::Min ? std::min(before, *value) : std::max(before, *value);
    if (!taken.since && holds(measure, *value)) taken.since = secondsOf(plc_.now() - begin_);
  }
  taken.value = value;
}

void Recorder::sample() {
  const Duration elapsed = plc_.now() - last_;
  last_ = plc_.now();
  for (std::size_t i = 0; i < measures_.size(); ++i) look(measures_[i], taken_[i], elapsed);
}

// From the first value on: the mean of a value that stays is this value, whatever it is.
std::optional<double> Recorder::meanOf(const Taken& taken) {
  if (taken.time.ns == 0) return taken.value;
  return taken.first + taken.away.value() / secondsOf(taken.time);
}

std::optional<double> Recorder::result(const Measure& measure, const Taken& taken) const {
  switch (measure.kind) {
    case Kind::Max:
    case Kind::Min:
      return taken.extreme;
    case Kind::Mean:
      return meanOf(taken);
    case Kind::Last:
      return taken.value;
    case Kind::Integral:
      return taken.integral.value();
    case Kind::Rising:
    case Kind::Falling:
    case Kind::Changes:
      return static_cast<double>(taken.count);
    case Kind::Time:
      return secondsOf(taken.held);
    case Kind::When:
      return taken.since;
    case Kind::Cycles:
      return static_cast<double>(plc_.cycles() - cycles_);
    case Kind::Instructions:
      return static_cast<double>(plc_.instructions() - instructions_);
  }
  return std::nullopt;
}

std::vector<std::optional<double>> Recorder::results() {
  sample();
  std::vector<std::optional<double>> results;
  for (std::size_t i = 0; i < measures_.size(); ++i)
    results.push_back(result(measures_[i], taken_[i]));
  return results;
}

}  // namespace merker::campaign
