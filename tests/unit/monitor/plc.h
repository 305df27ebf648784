// A station with a program and its monitor.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "cpu/cpu.h"
#include "monitor/cross_reference.h"
#include "monitor/monitor.h"
#include "step7/compiler.h"
#include "system/library.h"

namespace merker::monitor::test {

inline source::SymbolTable readTable(const std::string& text) {
  source::SymbolTable table;
  Problems problems;
  source::readSymbols(source::SourceFile("test.sym", text), table, problems);
  EXPECT_TRUE(problems.empty());
  return table;
}

class Plc {
 public:
  explicit Plc(const std::string& awl, const std::string& symbols = {})
      : symbols_(readTable(symbols)) {
    options_.library = &library_;
    options_.symbols = &symbols_;
    auto result = step7::compile({source::SourceFile("plant.awl", awl)}, options_);
    for (const Problem& problem : result.problems.list())
      if (problem.severity() == Severity::Error)
        ADD_FAILURE() << problem.position.line << ": " << problem.message;
    program_ = std::make_shared<const block::Program>(std::move(result.program));
    station::Options options;
    options.program = program_;
    station_ = std::make_unique<station::Station>(std::move(options));
    monitor_ = monitorOf(*station_, symbols_, resolver());
  }

  Monitor& operator*() { return *monitor_; }
  Monitor* operator->() { return monitor_.get(); }
  Debugger& debugger() { return monitor_->debugger(); }
  station::Station& station() { return *station_; }
  const block::Program& program() const { return *program_; }
  const source::SymbolTable& symbols() const { return symbols_; }
  simulator::Resolver resolver() const {
    return [this](std::string_view text, const Position& at) {
      return step7::resolve(text, *program_, options_, at);
    };
  }

  void start() { EXPECT_TRUE(station_->warmRestart()); }
  Instant soon() const { return station_->now() + Duration::seconds(1); }
  Pause run() { return debugger().run(soon()); }
  Pause step(StepKind kind = StepKind::Into) { return debugger().step(kind, soon()); }
  SourcePlace place(const std::string& text) const {
    const auto found = findLocation(text, monitor_->locations("plant.awl"));
    EXPECT_TRUE(found) << text;
    return found ? *found : SourcePlace{};
  }
  unsigned breakAt(const std::string& text) { return debugger().setBreakpoint(place(text)).number; }
  // "FC 1:12", or where it stands otherwise.
  std::string where() {
    const auto at = debugger().position();
    return at ? toString(at->block) + ":" + std::to_string(at->line) : "between cycles";
  }
  std::string read(const std::string& text, DisplayFormat format = DisplayFormat::Automatic) {
    const auto value = monitor_->read(text, format);
    return value ? *value : std::string(value.error().name());
  }

 private:
  block::Program library_ = system::library(defaultCpuModel());
  source::SymbolTable symbols_;
  step7::CompileOptions options_;
  std::shared_ptr<const block::Program> program_;
  std::unique_ptr<station::Station> station_;
  std::unique_ptr<Monitor> monitor_;
};

inline std::string name(const std::optional<Problem>& problem) {
  return problem ? std::string(problem->name()) : "good";
}

// Lines 1 to 19: FC 1 with two networks, called by OB 1; MW 20 counts cycles.
inline const char* const kProgram =
    "FUNCTION FC 1 : VOID\n"  // 1
    "VAR_INPUT\n"
    " in : INT;\n"
    "END_VAR\n"
    "VAR_TEMP\n"
    " sum : INT;\n"
    "END_VAR\n"
    "BEGIN\n"
    "NETWORK\n"
    " L #in;\n"  // 10
    " L 5;\n"
    " +I;\n"
    "NETWORK\n"
    " T #sum;\n"  // 14
    " T MW 12;\n"
    "END_FUNCTION\n"
    "ORGANIZATION_BLOCK OB 1\n"
    "BEGIN\n"
    "NETWORK\n"
    " L MW 20;\n"  // 20
    " + 1;\n"
    " T MW 20;\n"
    " CALL FC 1 (in := MW 10);\n"  // 23
    " U M 0.0;\n"
    " SPBN good;\n"
    " AUF DB 99;\n"  // 26
    "good: NOP 0;\n"
    "END_ORGANIZATION_BLOCK\n";

}  // namespace merker::monitor::test
