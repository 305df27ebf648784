#include "simulator/trace.h"

#include <fmt/format.h>

#include <ostream>

#include "simulator/display.h"
#include "simulator/duration.h"

namespace merker::simulator {
namespace {

// A timer is watched by its status bit: its time changes all the while.
mc7::Reference prepared(mc7::Reference reference) {
  if (reference.operand.kind == mc7::OperandKind::Timer) reference.operand.width = Width::Bit;
  if (reference.operand.kind == mc7::OperandKind::Counter) reference.operand.width = Width::Word;
  return reference;
}

std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string shown(const mc7::Reference& reference, std::uint32_t bits) {
  if (reference.operand.kind == mc7::OperandKind::Timer) return bits != 0 ? "1" : "0";
  return formatOperand(reference, bits);
}

}  // namespace

Trace::Trace(std::ostream& out, std::vector<mc7::Reference> watched,
             const station::Station& station)
    : out_(out) {
  for (mc7::Reference& reference : watched) {
    watched_.push_back(prepared(std::move(reference)));
    last_.push_back(station.read(watched_.back()));
  }
}

void Trace::sample(const station::Station& station) {
  for (std::size_t i = 0; i < watched_.size(); ++i) {
    const auto bits = station.read(watched_[i]);
    if (!bits || bits == last_[i]) continue;
    last_[i] = bits;
    // 7 decimals: 100 ns, the shortest instruction of the CPU 314C-2
    out_ << fmt::format("{},{},{}\n", formatSeconds(station.now().ns, 7), field(watched_[i].text),
                        field(shown(watched_[i], *bits)));
  }
}

}  // namespace merker::simulator
