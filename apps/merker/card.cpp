#include "card.h"

#include <fmt/format.h>

#include "project/settings.h"
#include "system/library.h"

namespace merker::app {
namespace {

store::LoadMemory loadMemoryOf(const Build& build, const block::Program& program) {
  return {std::string(build.project.model->keyword), project::configurationText(build.project),
          program};
}

store::LoadMemory loadMemoryOf(const Build& build) {
  if (!build.isListing()) return loadMemoryOf(build, *build.program);
  return {std::string(build.project.control->model->name),
          project::configurationText(build.project), cnc::toCard(build.listings)};
}

void switchOn(const block::RetentiveData* kept, bool changed, station::Station& station) {
  if (kept != nullptr) {
    block::RetentiveData data = *kept;
    data.running = data.running && !changed;
    station.restore(data);
    station.powerOn();
  } else {
    station.memoryReset();
  }
  if (station.mode() == station::Mode::Stop) station.warmRestart();
}

// Blocks of the source that differ from those that were loaded last; another merker.toml loads the
// data of the NC anew.
bool switchOn(const block::RetentiveData* kept, const store::Download& done, const Build& build,
              cnc::Cnc& control) {
  control.memoryReset();
  if (kept == nullptr) {
    control.start();
    return true;
  }
  block::RetentiveData data = *kept;
  data.running = data.running && !done.changed();
  const nc::Control configured = control.control();
  if (!cnc::restore(control, data)) return false;
  if (done.anotherConfiguration) control.control() = configured;
  for (const BlockId id : done.loaded)
    control.plc().programmer().load(build.listings.at(cnc::blockOf(id)));
  for (const BlockId id : done.deleted) control.plc().programmer().erase(cnc::blockOf(id));
  control.powerOn(true);
  return true;
}

}  // namespace

Result<store::MemoryCard> openCard(const std::string& folder, bool needsProgram) {
  auto card =
      needsProgram ? store::MemoryCard::openLoaded(folder) : store::MemoryCard::open(folder);
  if (!card) return card;
  const std::string& cpu = card->loadMemory().cpu;
  if (cpu.empty() || project::findModel(cpu)) return card;
  return makeProblem(ProblemCode::P1003, Position{folder},
                     fmt::format("it is the card of an unknown CPU '{}'", cpu));
}

Build buildFromCard(const store::MemoryCard& card, const std::string& folder,
                    const std::string& cpu) {
  const store::LoadMemory& load = card.loadMemory();
  Build result;
  result.project =
      project::loadConfiguration(folder, load.configuration, cpu.empty() ? load.cpu : cpu);
  result.library = std::make_shared<const block::Program>(system::library(*result.project.model));
  result.problems = result.project.problems;
  // A configuration with problems is never put on a card.
  if (cpu.empty() && result.problems.hasErrors()) result.project.unreadable = true;
  if (result.isListing()) {
    result.program = result.library;
    if (auto blocks = cnc::fromCard(load.program)) {
      result.listings = std::move(*blocks);
    } else {
      result.problems.add(ProblemCode::P1003, Position{folder}, "its blocks are not STEP 5 blocks");
      result.project.unreadable = true;
    }
  } else {
    result.program = std::make_shared<const block::Program>(load.program);
  }
  return result;
}

std::optional<Problem> switchOn(store::MemoryCard& card, const Build& build,
                                controller::Controller& plc) {
  const auto done = card.download(loadMemoryOf(build));
  if (!done) return done.error();
  const block::RetentiveData* kept = card.retentive() ? &*card.retentive() : nullptr;
  if (auto* control = dynamic_cast<cnc::Cnc*>(&plc)) {
    if (switchOn(kept, *done, build, *control)) return std::nullopt;
    return makeProblem(ProblemCode::P1003, Position{build.project.path},
                       "its retentive data are not those of a SINUMERIK");
  }
  switchOn(kept, done->changed(), dynamic_cast<station::Station&>(plc));
  return std::nullopt;
}

std::optional<Problem> copyRamToRom(store::MemoryCard& card, const Build& build,
                                    station::Station& station) {
  station.stop();
  station.copyRamToRom(build.project.parameters.password);
  const auto done = card.download(loadMemoryOf(build, station.program()));
  if (!done) return done.error();
  CardKeeper keeper(card);
  keeper.save(station);
  return keeper.problem();
}

bool CardKeeper::save(controller::Controller& plc) {
  if (problem_) return false;
  if (auto* control = dynamic_cast<cnc::Cnc*>(&plc)) {
    problem_ = card_.save(control_.look(*control));
    return !problem_;
  }
  dynamic_cast<station::Station&>(plc).retentive(data_);
  problem_ = card_.save(data_);
  return !problem_;
}

}  // namespace merker::app
