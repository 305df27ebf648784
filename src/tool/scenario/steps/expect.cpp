#include "scenario/steps/expect.h"

#include <fmt/format.h>

#include "base/text.h"
#include "scenario/duration.h"
#include "scenario/start.h"
#include "scenario/step.h"
#include "scenario/step_words.h"

namespace merker::simulator::steps {
namespace {

using controller::Controller;

bool isBlank(char c) { return c == ' ' || c == '\t'; }

// An expectation while time passes, on the PLC that it speaks of.
class Watch {
 public:
  Watch(const Expect& expect, StepRun& run)
      : expect_(expect), run_(run), end_(run.plc().now() + expect.duration) {}

  bool now() { return holds() || miss(); }

  // Now, at every cycle boundary, and at the end.
  bool during() {
    for (;;) {
      if (!holds()) return miss();
      if (run_.plc().now() >= end_) return true;
      goOn();
    }
  }

  // Ends at the first cycle boundary at which it holds.
  bool within() {
    for (;;) {
      if (holds()) return true;
      if (run_.plc().now() >= end_) return miss();
      goOn();
    }
  }

 private:
  // Cycles that leave what is looked at as it is need no look.
  void goOn() {
    const Instant before = plc().now();
    const auto stays = expect_.partner ? std::nullopt : staysUntil(expect_.what, plc());
    if (stays) plc().passQuietCycles(end_, *stays);
    if (plc().now() > before && *stays <= plc().now()) return;
    if (run_.plc().now() < end_) advanceToNextLook(run_.plc(), end_);
  }
  Controller& plc() { return expect_.partner ? *run_.plc().partner() : run_.plc(); }
  bool holds() { return simulator::holds(expect_.what, plc()); }

  // "expected A 1.2 = 1 within 300ms, A 1.2 is 0".
  bool miss() {
    std::string_view words = run_.step().text;
    words.remove_prefix(std::string_view("expect").size());
    return run_.failAt(run_.step().position,
                       fmt::format("expected {}, {}", trim(words), actual(expect_.what, plc())));
  }

  const Expect& expect_;
  StepRun& run_;
  Instant end_;
};

}  // namespace

// Takes "for 5s" or "within 5s" off the end.
bool Expect::takeTiming(const StepLine& line, std::string_view& rest) {
  const auto place = findOutside(rest, [](std::string_view tail) {
    std::string_view words = tail;
    if (!isBlank(tail.front()) || (tail.size() > 1 && isBlank(tail[1]))) return false;
    const std::string_view word = takeWord(words);
    return equalsIgnoreCase(word, "for") || equalsIgnoreCase(word, "within");
  });
  if (place == std::string_view::npos) return true;
  std::string_view length = rest.substr(place);
  when = equalsIgnoreCase(takeWord(length), "for") ? When::During : When::Within;
  rest = trim(rest.substr(0, place));
  const auto parsed = parseDuration(length);
  if (!parsed) return line.fail(ProblemCode::P0953, length.empty() ? rest : length, length);
  duration = *parsed;
  return true;
}

bool Expect::parse(const StepLine& line) {
  std::string_view rest = line.rest();
  if (!takeTiming(line, rest)) return false;
  std::string_view words = rest;
  partner = equalsIgnoreCase(takeWord(words), kPartner);
  return parseExpectation(line, partner ? words : rest, partner, what);
}

void Expect::resolve(const StepBinding& binding) {
  std::visit([&](IsExpectation auto& one) { one.resolve(binding); }, what);
}

bool Expect::perform(StepRun& run) const {
  if (const auto lacking = missing(what, run.plc()); !lacking.empty()) return run.lacks(lacking);
  if (partner && run.plc().partner() == nullptr) return run.noPartner();
  if (speaksOfState(what)) run.speakOfState();
  Watch watch(*this, run);
  switch (when) {
    case When::Now:
      break;
    case When::During:
      return watch.during();
    case When::Within:
      return watch.within();
  }
  return watch.now();
}

}  // namespace merker::simulator::steps
