#include "workbench/plc.h"

#include "scenario/long_value.h"
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
      controller_(controller ? std::move(controller) : made(*build_)),
      station_(dynamic_cast<station::Station*>(controller_.get())) {
  if (station_ == nullptr) return;
  const bool loaded = &station_->program() == build_->program.get();
  program_ = loaded ? build_->program : std::make_shared<block::Program>(station_->program());
  monitor_ = std::make_unique<monitor::Monitor>(
      *station_, symbols_,
      simulator::Resolver(
          [this](std::string_view text, const Position& at) { return operands_(text, at); },
          operands_.constants));
}

Plc::~Plc() = default;

void Plc::use(std::optional<station::Engine> engine) {
  if (station_ != nullptr && engine) station_->setEngine(*engine);
}

Result<address::Reference> Plc::operand(std::string_view text) const {
  if (monitor_) return monitor_->operand(text);
  auto reference = operands_(text, nowhere());
  if (reference && reference->operand.kind != address::OperandKind::Memory)
    reference->operand.width = Width::Word;
  return reference;
}

std::optional<monitor::Value> Plc::read(const address::Reference& reference) const {
  return monitor::read(*controller_, reference);
}

// A SINUMERIK. All of them or none: those that could not be done take the others back.
std::optional<Problem> Plc::control(const std::vector<monitor::Wish>& wishes, bool force) {
  struct Change {
    address::Reference reference;
    monitor::Value value, before;
  };
  std::vector<Change> changes;
  std::vector<monitor::Forced> good;
  for (const monitor::Wish& wish : wishes) {
    auto reference = operand(wish.operand);
    if (!reference) return reference.error();
    const auto value = monitor::parse(*reference, wish.value, wish.format);
    if (!value) return value.error();
    const auto old = read(*reference);
    if (!old) return makeProblem(ProblemCode::P1213, nowhere(), std::string(wish.operand));
    if (force && simulator::isLong(*reference))
      return makeProblem(ProblemCode::P1211, nowhere(), std::string(wish.operand));
    for (const auto* list : {&forces_, &good})
      if (auto problem = force ? monitor::checkForce(*list, *reference) : std::nullopt)
        return problem;
    good.push_back({*reference, value->bits});
    changes.push_back({std::move(*reference), *value, *old});
  }
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const auto& [reference, value, _] = changes[i];
    if (force ? controller_->force(reference, value.bits)
              : monitor::write(*controller_, reference, value))
      continue;
    while (i-- > 0)  // an image of inputs is read anew with the next cycle
      if (!force || changes[i].reference.operand.area != Area::Input)
        monitor::write(*controller_, changes[i].reference, changes[i].before);
    if (force) forceAgain();
    return makeProblem(force ? ProblemCode::P1211 : ProblemCode::P1212, nowhere(), reference.text);
  }
  if (force) noteForced(good);
  return std::nullopt;
}

void Plc::noteForced(const std::vector<monitor::Forced>& list) {
  for (const monitor::Forced& one : list) {
    std::erase_if(forces_,
                  [&](const auto& old) { return monitor::samePlace(old.operand, one.operand); });
    forces_.push_back(one);
  }
}

void Plc::forceAgain() {
  controller_->unforce();
  for (const monitor::Forced& one : forces_) controller_->force(one.operand, one.value);
}

std::optional<Problem> Plc::write(const std::vector<monitor::Wish>& wishes) {
  return monitor_ ? monitor_->write(wishes) : control(wishes, false);
}

std::optional<Problem> Plc::force(const std::vector<monitor::Wish>& wishes) {
  return monitor_ ? monitor_->force(wishes) : control(wishes, true);
}

std::optional<Problem> Plc::unforce(const std::vector<std::string_view>& operands) {
  if (monitor_) return monitor_->unforce(operands);
  std::vector<monitor::Forced> left = forces_;
  for (const std::string_view text : operands)
    if (std::erase_if(left, [&](const auto& one) { return one.operand.text == text; }) == 0)
      return makeProblem(ProblemCode::P1214, nowhere(), std::string(text));
  forces_ = std::move(left);
  forceAgain();
  return std::nullopt;
}

void Plc::unforceAll() {
  if (monitor_) return monitor_->unforceAll();
  forces_.clear();
  controller_->unforce();
}

const std::vector<monitor::Forced>& Plc::forces() const {
  return monitor_ ? monitor_->forces() : forces_;
}

void Plc::onCycle(Observer observer) {
  observers_.push_back(std::move(observer));
  controller_->onCycle([this](controller::Controller& plc) {
    for (const Observer& one : observers_) one(plc);
  });
}

std::string Plc::download(ProgramRef program) {
  std::string reason = station_->download(program);
  if (reason.empty()) program_ = std::move(program);
  return reason;
}

void Plc::take(const cpu::Snapshot& from, ProgramRef program) {
  station_->take(from, program);
  program_ = std::move(program);
}

void Plc::replace(BuildRef build, source::SymbolTable& symbols) {
  build_ = std::move(build);
  std::swap(symbols_, symbols);
  operands_ = build_->operands();
}

}  // namespace merker::workbench
