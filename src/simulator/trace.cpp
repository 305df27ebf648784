#include "simulator/trace.h"

#include <fmt/format.h>

#include <cstring>
#include <ostream>

#include "simulator/display.h"
#include "simulator/duration.h"
#include "simulator/long_value.h"

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

// Cheap to compare; a text is made of it only when it has changed.
std::optional<std::string> content(const mc7::Reference& reference,
                                   const controller::Controller& plc) {
  if (isLong(reference)) return readLong(reference, plc);
  const auto bits = plc.read(reference);
  if (!bits) return std::nullopt;
  std::string raw(sizeof *bits, '\0');
  std::memcpy(raw.data(), &*bits, sizeof *bits);
  return raw;
}

std::string shown(const mc7::Reference& reference, const std::string& content) {
  if (isLong(reference)) return formatLong(reference.type, content);
  std::uint32_t bits = 0;
  std::memcpy(&bits, content.data(), sizeof bits);
  if (reference.operand.kind == mc7::OperandKind::Timer) return bits != 0 ? "1" : "0";
  return formatOperand(reference, bits);
}

}  // namespace

Trace::Trace(std::ostream& out, std::vector<mc7::Reference> watched,
             const controller::Controller& plc)
    : out_(out) {
  for (mc7::Reference& reference : watched) {
    watched_.push_back(prepared(std::move(reference)));
    last_.push_back(content(watched_.back(), plc));
  }
}

void Trace::sample(const controller::Controller& plc) {
  for (std::size_t i = 0; i < watched_.size(); ++i) {
    const auto now = content(watched_[i], plc);
    if (!now || now == last_[i]) continue;
    last_[i] = now;
    // 7 decimals: 100 ns, the shortest instruction of the CPU 314C-2
    out_ << fmt::format("{},{},{}\n", formatSeconds(plc.now().ns, 7), field(watched_[i].text),
                        field(shown(watched_[i], *now)));
  }
}

}  // namespace merker::simulator
