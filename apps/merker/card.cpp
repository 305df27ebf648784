#include "card.h"

#include <fmt/format.h>

#include "plc/buffered_memory.h"
#include "project/settings.h"
#include "station/block_cpu.h"
#include "store/step5_blocks.h"
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
  result.library = std::make_shared<const block::Program>(
      system::library(*result.project.model, result.project.libraries));
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
  auto* const memory = controller::capability<controller::BufferedMemory>(plc);
  if (memory == nullptr || !card.retentive()) {
    plc.memoryReset();
    plc.start();
    return std::nullopt;
  }
  block::RetentiveData data = *card.retentive();
  data.running = data.running && !done->changed();
  if (memory->switchOn(data, *done)) return std::nullopt;
  return makeProblem(ProblemCode::P1003, Position{build.project.path},
                     fmt::format("its retentive data are not those of a {}", plc.modelName()));
}

std::optional<Problem> copyRamToRom(store::MemoryCard& card, const Build& build,
                                    controller::Controller& plc, cpu::RamToRom& memory) {
  plc.stop();
  memory.copyRamToRom(build.project.parameters.password);
  const auto done = card.download(loadMemoryOf(build, memory.program()));
  if (!done) return done.error();
  CardKeeper keeper(card);
  keeper.save(plc);
  return keeper.problem();
}

bool CardKeeper::save(controller::Controller& plc) {
  auto* const memory = controller::capability<controller::BufferedMemory>(plc);
  if (saveProgram(plc) && memory != nullptr) problem_ = card_.save(memory->kept());
  return !problem_;
}

bool CardKeeper::saveProgram(controller::Controller& plc) {
  const auto* const cpu = controller::capability<station::BlockCpu>(plc);
  if (problem_ || cpu == nullptr) return !problem_;
  const auto before = std::exchange(program_, cpu->loaded());
  if (before == nullptr || before == program_) return true;
  store::LoadMemory memory = card_.loadMemory();
  memory.program = *program_;
  const auto done = card_.download(std::move(memory));
  if (!done) problem_ = done.error();
  return !problem_;
}

}  // namespace merker::app
