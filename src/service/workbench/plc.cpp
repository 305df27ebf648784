#include "workbench/plc.h"

#include "plc/machine_code.h"
#include "workbench/json.h"

namespace merker::workbench {
namespace {

std::unique_ptr<controller::Controller> made(const compilation::Build& build) {
  if (build.ok()) {
    auto plc = build.controller();
    plc->memoryReset();
    plc->start();
    return plc;
  }
  return withoutProgram(build);
}

}  // namespace

std::unique_ptr<controller::Controller> withoutProgram(compilation::Build build) {
  build.program = std::make_shared<const block::Program>();
  build.listings.clear();
  return build.controller();
}

Plc::Plc(compilation::Build build, std::unique_ptr<controller::Controller> controller)
    : Plc(std::make_shared<const compilation::Build>(std::move(build)), std::move(controller)) {}

Plc::Plc(BuildRef build, std::unique_ptr<controller::Controller> controller)
    : build_(std::move(build)),
      symbols_(build_->project.symbols),
      operands_(build_->operands()),
      controller_(controller ? std::move(controller) : made(*build_)) {
  monitor_ = monitor::monitorOf(
      controller_->itself(), symbols_,
      simulator::Resolver(
          [this](std::string_view text, const Position& at) { return operands_(text, at); },
          operands_.constants));
}

Plc::~Plc() = default;

void Plc::use(std::optional<station::Engine> engine) {
  auto* code = controller::capability<controller::MachineCode>(*controller_);
  if (code != nullptr && engine) code->setCompiled(*engine == station::Engine::Compiled);
}

Result<address::Reference> Plc::operand(std::string_view text) const {
  return monitor_->operand(text);
}

std::optional<monitor::Value> Plc::read(const address::Reference& reference) const {
  return monitor::read(*controller_, reference);
}

void Plc::onCycle(Observer observer) {
  observers_.push_back(std::move(observer));
  controller_->onCycle([this](controller::Controller& plc) {
    for (const Observer& one : observers_) one(plc);
  });
}

ProgramRef Plc::program() const {
  const auto* cpu = controller::capability<station::BlockCpu>(std::as_const(*controller_));
  return cpu == nullptr ? nullptr : cpu->loaded();
}

std::string Plc::download(ProgramRef program) {
  return blockCpu()->download(std::move(program), {});
}

void Plc::take(const cpu::Snapshot& from, ProgramRef program) {
  blockCpu()->take(from, std::move(program));
}

void Plc::replace(BuildRef build, source::SymbolTable& symbols) {
  build_ = std::move(build);
  std::swap(symbols_, symbols);
  operands_ = build_->operands();
}

}  // namespace merker::workbench
