#include "scenario/trace.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <ostream>

#include "scenario/display.h"
#include "scenario/duration.h"
#include "scenario/long_value.h"

namespace merker::simulator {
namespace {

// A timer is watched by its status bit: its time changes all the while.
address::Reference prepared(address::Reference reference) {
  if (reference.operand.kind == address::OperandKind::Timer) reference.operand.width = Width::Bit;
  if (reference.operand.kind == address::OperandKind::Counter)
    reference.operand.width = Width::Word;
  return reference;
}

std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

// Cheap to compare; a text is made of it only when it has changed.
std::optional<std::string> content(const address::Reference& reference,
                                   const controller::Controller& plc) {
  if (isLong(reference)) return readLong(reference, plc);
  const auto bits = plc.read(reference);
  if (!bits) return std::nullopt;
  std::string raw(sizeof *bits, '\0');
  std::memcpy(raw.data(), &*bits, sizeof *bits);
  return raw;
}

std::string operandText(const address::Reference& reference, const std::string& content) {
  if (isLong(reference)) return formatLong(reference.type, content);
  std::uint32_t bits = 0;
  std::memcpy(&bits, content.data(), sizeof bits);
  if (reference.operand.kind == address::OperandKind::Timer) return bits != 0 ? "1" : "0";
  return formatOperand(reference, bits);
}

// Four digits, so that a curve is told in some hundred changes; a way of thousands of pulses in the
// seven digits of a message, never with an exponent (POS-PLANT-20).
std::string digits(double value) {
  const double amount = std::abs(value);
  if (amount < 1000) return fmt::format("{:.4g}", value);
  return amount < 1e6 ? fmt::format("{:.7g}", value) : fmt::format("{:.0f}", value);
}

}  // namespace

bool Watched::movesByItself() const {
  return !plants.empty() || !terminals.empty() ||
         std::ranges::any_of(operands, [](const address::Reference& one) {
           return one.operand.area == Area::Peripheral;
         });
}

Trace::Trace(std::ostream& out, Watched watched, const controller::Controller& plc)
    : out_(out),
      watched_(std::move(watched)),
      field_(controller::capability<plant::Field>(plc)),
      axis_(controller::capability<positioning::AxisOwner>(plc)) {
  for (address::Reference& reference : watched_.operands) {
    reference = prepared(std::move(reference));
    last_.push_back(content(reference, plc));
  }
  lastOutside_ = outside();
  for (std::size_t i = 0; i < lastOutside_.size(); ++i)
    write(plc.now(), nameOutside(i), lastOutside_[i]);
}

std::vector<std::string> Trace::outside() const {
  std::vector<std::string> values;
  for (const PlantValue& signal : watched_.plants)
    values.push_back(digits(field_->plants()->value(signal.place)));
  for (const TerminalValue& terminal : watched_.terminals)
    values.push_back(digits(presentValue(terminal, *field_->rack())));
  for (const AxisTerm& term : watched_.axis)
    values.push_back(fmt::format("{}", positioning::read(*term.what, *axis_->axis())));
  return values;
}

std::string Trace::nameOutside(std::size_t index) const {
  const std::size_t signals = watched_.plants.size(), terminals = watched_.terminals.size();
  if (index < signals) return "plant " + watched_.plants[index].text;
  return index < signals + terminals ? "terminal " + watched_.terminals[index - signals].text
                                     : watched_.axis[index - signals - terminals].text;
}

// 7 decimals: 100 ns, the shortest instruction of the CPU 314C-2
void Trace::write(Instant now, const std::string& name, const std::string& value) {
  out_ << fmt::format("{},{},{}\n", formatSeconds(now.ns, 7), field(name), field(value));
}

void Trace::sample(const controller::Controller& plc) {
  for (std::size_t i = 0; i < watched_.operands.size(); ++i) {
    const address::Reference& operand = watched_.operands[i];
    const auto now = content(operand, plc);
    if (!now || now == last_[i]) continue;
    last_[i] = now;
    write(plc.now(), operand.text, operandText(operand, *now));
  }
  std::vector<std::string> now = outside();
  for (std::size_t i = 0; i < now.size(); ++i)
    if (now[i] != lastOutside_[i]) write(plc.now(), nameOutside(i), now[i]);
  lastOutside_ = std::move(now);
}

}  // namespace merker::simulator
