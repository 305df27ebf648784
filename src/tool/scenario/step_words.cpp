#include "scenario/step_words.h"

#include <algorithm>
#include <iterator>
#include <type_traits>

#include "base/text.h"

namespace merker::simulator {
namespace {

template <IsStep S>
bool parse(const StepLine& line, AnyStep& step) {
  return step.emplace<S>().parse(line);
}

template <IsStep S, typename... All>
constexpr std::size_t placeOf(const std::variant<All...>*) {
  std::size_t place = 0;
  (void)((std::is_same_v<S, All> || (++place, false)) || ...);
  return place;
}

template <IsStep S>
constexpr StepWord word(std::string_view words) {
  return {words, parse<S>, false, placeOf<S>(static_cast<const AnyStep*>(nullptr))};
}

// One that the coupled control can do, too.
template <IsStep S>
constexpr StepWord partnerWord(std::string_view words) {
  StepWord row = word<S>(words);
  row.partner = true;
  return row;
}

constexpr StepWord kSteps[] = {
    word<steps::Set>("set"),
    word<steps::Wait>("wait"),
    word<steps::Expect>("expect"),
    partnerWord<steps::Run>("run"),
    partnerWord<steps::Stop>("stop"),
    partnerWord<steps::ColdRestart>("cold restart"),
    partnerWord<steps::WarmRestart>("warm restart"),
    word<steps::HotRestart>("hot restart"),
    word<steps::Switch>("switch"),
    partnerWord<steps::PowerOff>("power off"),
    partnerWord<steps::PowerOnUnbuffered>("power on unbuffered"),
    partnerWord<steps::PowerOn>("power on"),
    partnerWord<steps::BatteryLow>("battery low"),
    partnerWord<steps::BatteryGood>("battery good"),
    word<steps::RemoveCard>("remove card"),
    word<steps::Trigger>("trigger"),
    partnerWord<steps::MemoryReset>("memory reset"),
    word<steps::CopyRamToRom>("copy RAM to ROM"),
    word<steps::Force>("force"),
    word<steps::Unforce>("unforce"),
    partnerWord<steps::Fault>("fault"),
    word<steps::Terminal>("terminal"),
    word<steps::Pulses>("pulses"),
    word<steps::Encoder>("encoder"),
    word<steps::Plant>("plant"),
    word<steps::Repeat>("repeat"),
};

constexpr bool everyStepHasWords() {
  for (std::size_t type = 0; type < std::variant_size_v<AnyStep>; ++type)
    if (std::none_of(std::begin(kSteps), std::end(kSteps),
                     [&](const StepWord& row) { return row.type == type; }))
      return false;
  return true;
}
static_assert(everyStepHasWords());

}  // namespace

bool takeWords(std::string_view& line, std::string_view wanted) {
  std::string_view rest = line;
  while (!wanted.empty()) {
    const std::string_view one = takeWord(rest);
    if (!equalsIgnoreCase(one, takeWord(wanted))) return false;
  }
  line = rest;
  return true;
}

const StepWord* takeStepWord(std::string_view& line) {
  for (const StepWord& step : kSteps)
    if (takeWords(line, step.words)) return &step;
  return nullptr;
}

bool expectsSignal(std::string_view line) {
  if (!equalsIgnoreCase(takeWord(line), "expect")) return false;
  const std::string_view one = takeWord(line);
  return equalsIgnoreCase(one, "pulses") || equalsIgnoreCase(one, "encoder");
}

std::string stepWords() {
  std::string list;
  for (const StepWord& step : kSteps) list += std::string(step.words) + ", ";
  return list + "end";
}

}  // namespace merker::simulator
