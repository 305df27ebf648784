#include "program.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "step7/compiler.h"
#include "system/library.h"

namespace merker::station::test {

std::shared_ptr<const block::Program> compileAwl(std::string_view awl, const CpuModel& model) {
  const std::string text =
      awl.find("ORGANIZATION_BLOCK") != std::string_view::npos
          ? std::string(awl)
          : "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n info : ARRAY [1..20] OF BYTE;\nEND_VAR\nBEGIN\n" +
                std::string(awl) + "\nEND_ORGANIZATION_BLOCK\n";
  const block::Program library = system::library(model);
  step7::CompileOptions options;
  options.model = &model;
  options.library = &library;
  options.checks = true;
  step7::Compilation result = step7::compile({source::SourceFile("test.awl", text)}, options);
  for (const Problem& problem : result.problems.list())
    if (problem.severity() == Severity::Error)
      ADD_FAILURE() << problem.position.line << ": " << problem.message;
  return std::make_shared<const block::Program>(std::move(result.program));
}

std::string ob(int number, std::string_view body) {
  return "ORGANIZATION_BLOCK OB " + std::to_string(number) +
         "\nVAR_TEMP\n info : ARRAY [1..20] OF BYTE;\n x : INT;\nEND_VAR\nBEGIN\n" +
         std::string(body) + "\nEND_ORGANIZATION_BLOCK\n";
}

Plc::Plc(std::string_view awl, const CpuModel& model) : Plc(awl, model, CpuParameters::of(model)) {}

Plc::Plc(std::string_view awl, const CpuModel& model, CpuParameters parameters)
    : program_(compileAwl(awl, model)),
      model_(&model),
      station_({.model = &model, .parameters = std::move(parameters), .program = program_}) {}

Plc::Plc(std::string_view awl, const CpuModel& model, io::Configuration hardware)
    : program_(compileAwl(awl, model)),
      model_(&model),
      station_({.model = &model, .hardware = std::move(hardware), .program = program_}) {}

address::Reference Plc::reference(std::string_view operand) const {
  step7::CompileOptions options;
  options.model = model_;
  const auto result = step7::resolve(operand, *program_, options, {});
  EXPECT_TRUE(result) << operand;
  return result ? *result : address::Reference{};
}

std::uint32_t Plc::read(std::string_view operand) {
  const auto value = station_.read(reference(operand));
  EXPECT_TRUE(value.has_value()) << operand;
  return value.value_or(0xDEADBEEF);
}

void Plc::write(std::string_view operand, std::uint32_t value) {
  EXPECT_TRUE(station_.write(reference(operand), value)) << operand;
}

bool Plc::force(std::string_view operand, std::uint32_t value) {
  return station_.force(reference(operand), value);
}

void Plc::cycles(std::uint64_t count) {
  if (station_.mode() == Mode::Stop) {
    EXPECT_TRUE(station_.warmRestart());
  }
  station_.advanceCycles(count);
}

unsigned Plc::lastEvent() const {
  return station_.diagnostics().empty() ? 0u : station_.diagnostics().back().event;
}

bool Plc::hasEvent(unsigned event) const { return countEvents(event) > 0; }

std::size_t Plc::countEvents(unsigned event) const {
  const auto& all = station_.diagnostics();
  return static_cast<std::size_t>(std::count_if(
      all.begin(), all.end(), [&](const DiagnosticEntry& e) { return e.event == event; }));
}

}  // namespace merker::station::test
