#include "workbench/trend.h"

#include <cmath>
#include <limits>
#include <utility>

#include "scenario/display.h"
#include "scenario/long_value.h"
#include "workbench/operand_name.h"

namespace merker::workbench {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
// Of one event: some milliseconds of work for both sides.
constexpr std::size_t kValuesOfEvent = 10'000;

// plant.Oven.PV
std::optional<plant::SignalPlace> signalOf(std::string_view name, const Plc& plc) {
  constexpr std::string_view kPrefix = "plant.";
  const plant::Plants* plants = plc.plants();
  if (!name.starts_with(kPrefix) || plants == nullptr) return std::nullopt;
  name.remove_prefix(kPrefix.size());
  const std::size_t point = name.find('.');
  if (point == std::string_view::npos) return std::nullopt;
  const auto found = plants->configuration().find(name.substr(0, point));
  if (!found) return std::nullopt;
  const auto signal = plants->configuration().plants[*found].kind->signal(name.substr(point + 1));
  return signal ? std::optional(plant::SignalPlace{*found, *signal}) : std::nullopt;
}

// terminal.2.2.DO0, as scenarios name it behind the first point.
std::optional<io::Terminal> terminalOf(std::string_view name, const Plc& plc) {
  constexpr std::string_view kPrefix = "terminal.";
  const io::Rack* rack = plc.rack();
  if (!name.starts_with(kPrefix) || rack == nullptr) return std::nullopt;
  const auto known = io::parseTerminal(name.substr(kPrefix.size()));
  if (!known) return std::nullopt;
  const auto terminal = rack->terminal(known->module, known->side, known->channel);
  const bool off = terminal && !isDigital(known->side) && rack->range(*terminal) == nullptr;
  return off ? std::nullopt : terminal;
}

const positioning::Channel* axisOf(const Plc& plc) {
  const auto* owner = controller::capability<positioning::AxisOwner>(plc.controller());
  return owner == nullptr ? nullptr : owner->axis();
}

// axis.position
const positioning::AxisValue* axisValueOf(std::string_view name, const Plc& plc) {
  constexpr std::string_view kPrefix = "axis.";
  if (!name.starts_with(kPrefix) || axisOf(plc) == nullptr) return nullptr;
  return positioning::findAxisValue(name.substr(kPrefix.size()));
}

Json describeTerminal(const std::string& name, io::Terminal terminal, const Plc& plc) {
  const MeasuringRange* range = plc.rack()->range(terminal);
  return {{"operand", name},
          {"symbol", ""},
          {"unit", range == nullptr ? "" : unitOf(range->quantity)},
          {"bits", range == nullptr ? 1 : 0}};
}

}  // namespace

Json Trend::describe(const std::string& name, Source& source, const Plc& plc) const {
  source = std::monostate{};
  if (const auto signal = signalOf(name, plc)) {
    source = *signal;
    const plant::PlantSettings& settings = plc.plants()->configuration().plants[signal->plant];
    const plant::Signal& what = settings.kind->signals[signal->signal];
    return {{"operand", name}, {"symbol", ""}, {"unit", what.unit}, {"bits", what.binary ? 1 : 0}};
  }
  if (const auto terminal = terminalOf(name, plc)) {
    source = *terminal;
    return describeTerminal(name, *terminal, plc);
  }
  if (const positioning::AxisValue* value = axisValueOf(name, plc)) {
    source = value;
    return {
        {"operand", name}, {"symbol", ""}, {"unit", value->unit}, {"bits", value->binary ? 1 : 0}};
  }
  auto reference = plc.operand(name);
  if (!reference)
    return {{"operand", name}, {"symbol", ""}, {"problem", toJson(reference.error())}};
  const OperandName named = operandName(*reference, plc.build().project.symbols);
  Json json = {{"operand", named.operand},
               {"symbol", named.symbol},
               {"type", named.type},
               {"bits", named.bits}};
  if (simulator::isLong(*reference) && reference->nc == 0)
    json["problem"] =
        toJson(makeProblem(ProblemCode::P1209, nowhere(), name, "a curve", "1 to 32"));
  else
    source = std::move(*reference);
  return json;
}

Json Trend::describe(const Plc& plc) {
  Json list = Json::array();
  sources_.resize(names_.size());
  for (std::size_t i = 0; i < names_.size(); ++i)
    list.push_back(describe(names_[i], sources_[i], plc));
  return list;
}

double Trend::value(const Source& source, const Plc& plc) {
  if (const auto* signal = std::get_if<plant::SignalPlace>(&source))
    return plc.plants()->value(*signal);
  if (const auto* terminal = std::get_if<io::Terminal>(&source)) {
    const io::Rack& rack = *plc.rack();
    return isDigital(terminal->side) ? double(rack.level(*terminal)) : rack.amount(*terminal);
  }
  if (const auto* axis = std::get_if<const positioning::AxisValue*>(&source))
    return axisOf(plc) == nullptr ? kNothing
                                  : static_cast<double>(positioning::read(**axis, *axisOf(plc)));
  const auto* reference = std::get_if<address::Reference>(&source);
  if (reference != nullptr && reference->nc != 0) {
    const auto digits = simulator::readLong(*reference, plc.controller());
    return digits ? std::stod(*digits) : kNothing;
  }
  const auto bits = reference == nullptr ? std::nullopt : plc.controller().read(*reference);
  if (!bits) return kNothing;
  return std::visit([](auto number) { return static_cast<double>(number); },
                    simulator::numericValue(*reference, *bits));
}

void Trend::sample(const Plc& plc) {
  const Instant now = plc.controller().now();
  if (now < next_ && now + every_ >= next_) return;  // unless time began anew
  next_ = now + every_;
  rows_.push_back(static_cast<double>(now.ns) / 1e6);
  for (const Source& source : sources_) rows_.push_back(value(source, plc));
  const std::size_t length = sources_.size() + 1;
  while (rows_.size() > mostRows_ * length)
    rows_.erase(rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(length));
}

std::string Trend::takeRows(const Plc& plc, std::uint64_t program) {
  if (program_ != 0 && program_ != program) describe(plc);
  program_ = program;
  const std::size_t length = sources_.size() + 1;
  const std::size_t rows = std::min(rows_.size(), std::max(kValuesOfEvent, length)) / length;
  if (rows == 0) return {};
  std::string text;
  for (std::size_t i = 0; i < rows * length; ++i) {
    text += i == 0 ? "[[" : i % length == 0 ? "],[" : ",";
    text += std::isfinite(rows_[i]) ? dump(Json(rows_[i])) : "null";
  }
  rows_.erase(rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(rows * length));
  return text + "]]";
}

}  // namespace merker::workbench
