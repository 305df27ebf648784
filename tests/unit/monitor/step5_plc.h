// A SINUMERIK with a program and its monitor: plc.h for the other family.
#pragma once

#include <memory>
#include <string>

#include "control/cnc.h"
#include "control/reference.h"
#include "listing.h"
#include "monitor/monitor.h"
#include "step5/variable.h"

namespace merker::monitor::test {

// "MW 10", "DB10.DW 1", "nc.R 5", and the same of the control that it is coupled with.
inline Result<address::Reference> step5Operand(std::string_view text, const Position& at) {
  constexpr std::string_view kPartner = "partner ";
  const bool partner = text.starts_with(kPartner);
  const std::string_view own = partner ? text.substr(kPartner.size()) : text;
  if (auto problem = step5::checkRange(own, nullptr, at)) return *problem;
  auto reference = step5::parseVariable(own);
  if (!reference) reference = cnc::datumReference(own);
  if (!reference) return makeProblem(ProblemCode::P1104, at, std::string(text));
  reference->partner = partner;
  reference->text = text;
  return *reference;
}

inline std::unique_ptr<cnc::Cnc> controlOf(const std::string& text) {
  cnc::Options options;
  options.plc.program = listing(text);
  return std::make_unique<cnc::Cnc>(std::move(options));
}

class SinumerikPlc {
 public:
  explicit SinumerikPlc(const std::string& text)
      : control_(controlOf(text)),
        monitor_(monitorOf(*control_, symbols_,
                           simulator::Resolver(step5Operand, cnc::parseConstant, true))) {}

  Monitor& operator*() { return *monitor_; }
  Monitor* operator->() { return monitor_.get(); }
  Debugger& debugger() { return monitor_->debugger(); }
  cnc::Cnc& control() { return *control_; }

  void start() { EXPECT_TRUE(control_->start()); }
  Instant soon() const { return control_->now() + Duration::seconds(1); }
  Pause run() { return debugger().run(soon()); }
  Pause step(StepKind kind = StepKind::Into) { return debugger().step(kind, soon()); }
  SourcePlace place(const std::string& text) const {
    const auto found = findLocation(text, monitor_->locations("press.s5"));
    EXPECT_TRUE(found) << text;
    return found ? *found : SourcePlace{};
  }
  unsigned breakAt(const std::string& text) { return debugger().setBreakpoint(place(text)).number; }
  // "PB 5:14", or where it stands otherwise.
  std::string where() {
    const auto at = debugger().position();
    return at ? toString(at->block) + ":" + std::to_string(at->line) : "between cycles";
  }
  // Through these places, one step each.
  void expectSteps(StepKind kind, std::initializer_list<const char*> places) {
    for (const char* expected : places) {
      step(kind);
      EXPECT_EQ(where(), expected);
    }
  }
  std::string read(const std::string& text, DisplayFormat format = DisplayFormat::Automatic) {
    const auto value = monitor_->read(text, format);
    return value ? *value : std::string(value.error().name());
  }

 private:
  source::SymbolTable symbols_;
  std::unique_ptr<cnc::Cnc> control_;
  std::unique_ptr<Monitor> monitor_;
};

// OB 1 counts its cycles in MW 120; E 0.7 leads to alarm 6103 in line 26.
inline const char* const kPress =
    "OB 1\n"
    " : L   MW 120\n"  // 2
    " : L   KF +1\n"
    " : +F\n"
    " : T   MW 120\n"
    " : SPA FB 5\n"  // 6
    "NAME : VENTIL\n"
    "EIN : E 1.0\n"
    " : SPA PB 5\n"  // 9
    " : U   E 0.7\n"
    " : SPB PB 6\n"
    " : BE\n"  // 12
    "PB 5\n"
    " : A   DB 10\n"  // 14, word 0
    " : L   DW 1\n"
    " : L   KH 0004\n"  // 16, words 2 and 3
    " : +F\n"
    " : T   MW 110\n"
    " : U   E 0.6\n"
    " : BEB\n"  // 20
    " : L   KF +7\n"
    " : T   MW 114\n"
    " : BE\n"  // 23
    "PB 6\n"
    " : L   KF +1\n"
    " : T   DW 2\n"  // 26, no data block is open
    " : BE\n"
    "DB 10\n"
    "   0 : KH = 0000\n"
    "   1 : KF = +5\n"
    "FB 5\n"
    "NAME : VENTIL\n"
    "BEZ : EIN  E/A/D/B/T/Z: E  BI/BY/W/D: BI\n"
    " : U   =EIN\n"  // 34
    " : =   M 101.0\n"
    " : BE\n";

// A loop with three passes, and B MW 104 before L EB 0.
inline const char* const kLoop =
    "OB 1\n"
    " : SPA FB 6\n"
    "NAME : LOOP\n"
    " : BE\n"
    "FB 6\n"
    "NAME : LOOP\n"
    " : L   KF +3\n"  // 7
    " : T   MW 112\n"
    "M1 : L   MW 112\n"  // 9
    " : L   KF -1\n"
    " : +F\n"
    " : T   MW 112\n"  // 12
    " : L   KF +0\n"
    " : ><F\n"
    " : SPB =M1\n"
    " : B   MW 104\n"  // 16, word 12
    " : L   EB 0\n"
    " : T   MB 130\n"  // 18
    " : UN  M 131.0\n"
    " : BEB\n"  // 20
    " : L   KF +9\n"
    " : BE\n";

// OB 1 does not end; E 7.0 starts OB 2, which counts in MW 130 and, with E 0.7, fails in line 20.
inline const char* const kInterrupted =
    "OB 1\n"
    " : SPA FB 1\n"
    "NAME : WAIT\n"
    " : BE\n"
    "FB 1\n"
    "NAME : WAIT\n"
    "M1 : L   MW 110\n"  // 7
    " : L   MW 112\n"
    " : SPA =M1\n"
    " : BE\n"
    "OB 2\n"
    " : L   MW 130\n"  // 12
    " : L   KF +1\n"
    " : +F\n"
    " : T   MW 130\n"
    " : U   E 0.7\n"
    " : SPB PB 1\n"
    " : BE\n"
    "PB 1\n"
    " : T   DW 0\n"  // 20
    " : BE\n";

}  // namespace merker::monitor::test
