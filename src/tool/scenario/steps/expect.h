// expect A = B [for 5s | within 300ms]: what holds now, during a time, or at the latest then.
#pragma once

#include <string_view>

#include "clock/instant.h"
#include "scenario/expectation.h"
#include "scenario/step_run.h"

namespace merker::simulator::steps {

struct Expect {
  static constexpr std::string_view kWords = "expect";

  AnyExpectation what;
  enum class When : std::uint8_t { Now, During, Within } when = When::Now;
  Duration duration;     // During, Within
  bool partner = false;  // mode, diagnostics: of the coupled control

  bool parse(const StepLine& line);
  void resolve(const StepBinding& binding);
  bool perform(StepRun& run) const;

 private:
  bool takeTiming(const StepLine& line, std::string_view& rest);
};

}  // namespace merker::simulator::steps
