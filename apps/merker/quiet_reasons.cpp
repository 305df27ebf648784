#include "quiet_reasons.h"

#include <fmt/format.h>

#include <iostream>
#include <vector>

#include "monitor/cross_reference.h"
#include "plc/quiet_cycles.h"
#include "scenario/start.h"

namespace merker::app {
namespace {

using controller::QuietCycles;
using monitor::CrossReference;

// "OB 1 network 3 (main.awl:12)", as far as it is known.
std::string text(const monitor::SourcePlace& place) {
  std::string text = toString(place.block);
  if (place.network != 0) text += fmt::format(" network {}", place.network);
  if (place.line != 0) return text + fmt::format(" ({}:{})", place.file, place.line);
  const bool bytes = place.unit == monitor::CodeUnit::Byte;
  return text + fmt::format(" ({} {})", bytes ? "byte" : "word", place.offset);
}

// The instructions of the program that write it; the first few of many.
std::string writersOf(const std::string& operand, const Build& built) {
  constexpr std::size_t kShown = 3;
  const auto list = monitor::crossReferences(built.code(), built.project.symbols,
                                             {.library = built.library.get()});
  const auto rows = monitor::filtered(list, operand, built.resolver(),
                                      monitor::filterWords(built.code()), built.project.symbols);
  if (!rows) return {};
  std::vector<std::string> places;
  for (const CrossReference& row : rows.value())
    if (row.use == monitor::Use::Write || row.use == monitor::Use::ReadWrite)
      places.push_back(text(row.place));
  if (places.empty()) return "; no instruction names it to write it";
  std::string all;
  for (std::size_t i = 0; i < std::min(places.size(), kShown); ++i)
    all += (i == 0 ? "; written at " : ", ") + places[i];
  if (places.size() > kShown) all += fmt::format(" and {} more", places.size() - kShown);
  return all;
}

std::string text(const QuietCycles::Reason& reason, const Build& built) {
  if (reason.place)
    return fmt::format("{}, at {}", reason.text,
                       text(sourcePlace(built.code(), reason.place->block, reason.place->offset)));
  return reason.changed.empty() ? reason.text : reason.text + writersOf(reason.changed, built);
}

void printReason(std::uint64_t cycles, std::uint64_t all, const std::string& text) {
  const double share = 100.0 * static_cast<double>(cycles) / static_cast<double>(all);
  std::cout << fmt::format("{:10} {:5.1f} %  {}\n", cycles, share, text);
}

// Each cycle that was computed is in one line.
void printReasons(const QuietCycles& quiet, std::uint64_t computed, const Build& built) {
  std::uint64_t told = 0;
  for (const QuietCycles::Reason& reason : quiet.whyComputed()) {
    printReason(reason.cycles, computed, text(reason, built));
    told += reason.cycles;
  }
  if (told < computed)
    printReason(computed - told, computed,
                "not asked for: a start, or an interrupt at the end of the cycle");
}

}  // namespace

std::string tellWhy(const Build& built, Duration time) {
  const auto plc = built.controller();
  const auto* const quiet = controller::capability<QuietCycles>(*plc);
  if (quiet == nullptr) return fmt::format("{} has no {}", plc->modelName(), QuietCycles::kName);
  if (const std::string reason = simulator::startFresh(*plc); !reason.empty()) return reason;
  const std::uint64_t before = plc->cycles();
  plc->advanceTo(plc->now() + time);
  const std::uint64_t all = plc->cycles() - before, passed = quiet->cyclesPassedOver();
  std::cout << fmt::format("{} cycles, {} computed, {} passed over\n", all, all - passed, passed);
  printReasons(*quiet, all - passed, built);
  return plc->stoppedByFault() ? "the CPU went to STOP: " + plc->stopReason() : "";
}

}  // namespace merker::app
