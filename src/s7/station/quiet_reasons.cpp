// Why cycles were computed, in words.
#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "station/parts.h"

namespace merker::station {
namespace {

using cpu::Look;
using cpu::NotQuiet;

using Reason = controller::QuietCycles::Reason;

// A look that is known before the program runs: whether its instruction is executed is not known.
std::string lookText(const Look& look) {
  switch (look.at) {
    case Look::At::Date:
      return fmt::format("{} has an instruction that reads its date and time, executed or not",
                         toString(look.block));
    case Look::At::Timer:
      return look.block == BlockId{}
                 ? fmt::format("T {} ends within the cycle", look.number)
                 : fmt::format(
                       "the time of T {} runs, and {} has an instruction that loads it, "
                       "executed or not",
                       look.number, toString(look.block));
    case Look::At::SystemBlock:
      return fmt::format("{} calls {}", toString(look.block), toString(look.called));
    case Look::At::Error:
      return fmt::format("{} has a synchronous error", toString(look.block));
    case Look::At::Output:
      return "peripheral outputs change within the cycle";
    case Look::At::Nothing:
      break;
  }
  return "OB 1 is not the only OB";
}

Reason looked(const Look& look) {
  Reason reason{.text = lookText(look)};
  if (look.block != BlockId{} && look.offset != Look::kUnknown)
    reason.place = {look.block, look.offset};
  return reason;
}

std::string differencePlace(const cpu::StateCopy::Difference& where) {
  if (where.area == "T" || where.area == "Z") return fmt::format("{} {}", where.area, where.number);
  if (where.area == "DB") return fmt::format("DB{}.DBB {}", where.number, where.byte);
  if (where.area == "PE") return fmt::format("PEB {}", where.number + where.byte);
  if (where.area == "PA") return fmt::format("PAB {}", where.byte);
  return where.area == "L" ? "" : fmt::format("{}B {}", where.area, where.byte);
}

// Of an output the process image is what the program writes.
Reason changed(const cpu::StateCopy::Difference& where) {
  const std::string operand = differencePlace(where);
  if (operand.empty()) return {.text = "a temporary variable changes"};
  if (where.area == "E" || where.area == "PE") return {.text = operand + ", an input, changes"};
  const bool output = where.area == "PA";
  return {.text = operand + " changes",
          .changed = output ? fmt::format("AB {}", where.byte) : operand};
}

constexpr std::string_view textOf(NotQuiet::Why why) {
  using Why = NotQuiet::Why;
  switch (why) {
    case Why::Outside:
      return "first cycle after something was asked or changed from outside";
    case Why::Start:
      return "first cycle after the start";
    case Why::LeftOut:
      return "not looked at: those before proved nothing, and looking costs time";
    case Why::Proof:
      return "the same as the one before: the next ones need not be computed";
    case Why::OtherOb:
      return "another OB than OB 1 runs";
    case Why::Event:
      return "modules, plants, clock memory or an interrupt act within the cycle";
    case Why::Duration:
      return "the cycle takes another time than the one before";
    case Why::Modules:
      return "inputs are counted, follow a signal or come over a bus";
    case Why::Watched:
      return "each instruction is looked at or counted";
    case Why::Memory:
    case Why::Looked:
    case Why::kCount:
      break;
  }
  return {};
}

Reason reasonOf(const NotQuiet& one) {
  if (one.why == NotQuiet::Why::Memory) return changed(one.where);
  if (one.why == NotQuiet::Why::Looked) return looked(one.look);
  return {.text = std::string(textOf(one.why))};
}

}  // namespace

void Station::passOverQuietCycles(bool on) {
  parts_->cpu.quiet().enable(on);
  if (parts_->partner) parts_->partner->passOverQuietCycles(on);
}
std::uint64_t Station::cyclesPassedOver() const { return parts_->cpu.quiet().cycles(); }

std::vector<Station::Reason> Station::whyComputed() const {
  const cpu::QuietCycles& quiet = parts_->cpu.quiet();
  std::vector<Reason> reasons;
  for (std::size_t i = 0; i < quiet.counts().size(); ++i) {
    if (quiet.counts()[i] == 0) continue;
    reasons.push_back(reasonOf(quiet.last(static_cast<NotQuiet::Why>(i))));
    reasons.back().cycles = quiet.counts()[i];
  }
  std::ranges::stable_sort(reasons, std::ranges::greater{}, &Reason::cycles);
  return reasons;
}

}  // namespace merker::station
