// Why cycles were computed, in words.
#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "station/parts.h"

namespace merker::station {
namespace {

using cpu::Look;
using cpu::NotQuiet;

// " (main.awl:12)"
std::string lookLine(const Look& look, const block::Program& program) {
  const auto found = program.find(look.block);
  if (found == program.end() || look.offset == Look::kUnknown) return {};
  const std::uint32_t line = found->second.line(look.offset);
  return line == 0 ? fmt::format(" (byte {})", look.offset)
                   : fmt::format(" ({}:{})", found->second.file, line);
}

std::string lookText(const Look& look, const block::Program& program) {
  const std::string at = lookLine(look, program);
  switch (look.at) {
    case Look::At::Date:
      return fmt::format("{} reads the date and time of OB 1{}", toString(look.block), at);
    case Look::At::Timer:
      return fmt::format("the time of T {} runs, and the next change is less than a cycle away",
                         look.number);
    case Look::At::SystemBlock:
      return fmt::format("{} calls {}{}", toString(look.block), toString(look.called), at);
    case Look::At::Error:
      return fmt::format("{} has a synchronous error{}", toString(look.block), at);
    case Look::At::Output:
      return "peripheral outputs change within the cycle";
    case Look::At::Nothing:
      break;
  }
  return "OB 1 is not the only OB";
}

std::string differencePlace(const cpu::StateCopy::Difference& where) {
  if (where.area == "T" || where.area == "Z") return fmt::format("{} {}", where.area, where.number);
  if (where.area == "DB") return fmt::format("DB{}.DBB {}", where.number, where.byte);
  if (where.area == "PE") return fmt::format("PEB {}", where.number + where.byte);
  return where.area == "L" ? "a temporary variable" : fmt::format("{}B {}", where.area, where.byte);
}

std::string reasonText(const NotQuiet& one, const block::Program& program) {
  using Why = NotQuiet::Why;
  switch (one.why) {
    case Why::Outside:
      return "first cycle after something was asked or changed from outside";
    case Why::Memory:
      return differencePlace(one.where) + " changes";
    case Why::Looked:
      return lookText(one.look, program);
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
    case Why::kCount:
      break;
  }
  return {};
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
  for (std::size_t i = 0; i < quiet.counts().size(); ++i)
    if (quiet.counts()[i] != 0)
      reasons.push_back(
          {reasonText(quiet.last(static_cast<NotQuiet::Why>(i)), program()), quiet.counts()[i]});
  std::ranges::stable_sort(reasons, std::ranges::greater{}, &Reason::cycles);
  return reasons;
}

}  // namespace merker::station
