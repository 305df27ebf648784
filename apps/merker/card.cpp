#include "card.h"

#include "system/library.h"

namespace merker::app {
namespace {

store::LoadMemory loadMemoryOf(const Build& build, const block::Program& program) {
  return {std::string(build.project.model->keyword), project::configurationText(build.project),
          program};
}

}  // namespace

Build buildFromCard(const store::MemoryCard& card, const std::string& folder,
                    const std::string& cpu) {
  const store::LoadMemory& load = card.loadMemory();
  Build result;
  result.project =
      project::loadConfiguration(folder, load.configuration, cpu.empty() ? load.cpu : cpu);
  result.library = std::make_shared<const block::Program>(system::library(*result.project.model));
  result.program = std::make_shared<const block::Program>(load.program);
  result.problems = result.project.problems;
  // A configuration with problems is never put on a card.
  if (cpu.empty() && result.problems.hasErrors()) result.project.unreadable = true;
  if (card.empty()) {
    result.problems.add(ProblemCode::P1007, Position{folder});
    result.project.unreadable = true;
  }
  return result;
}

std::optional<Problem> switchOn(store::MemoryCard& card, const Build& build,
                                station::Station& station) {
  const auto done = card.download(loadMemoryOf(build, *build.program));
  if (!done) return done.error();
  if (card.retentive()) {
    block::RetentiveData data = *card.retentive();
    data.running = data.running && !done->changed();
    station.restore(data);
    station.powerOn();
  } else {
    station.memoryReset();
  }
  if (station.mode() == station::Mode::Stop) station.warmRestart();
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

bool CardKeeper::save(const station::Station& station) {
  if (problem_) return false;
  station.retentive(data_);
  problem_ = card_.save(data_);
  return !problem_;
}

}  // namespace merker::app
