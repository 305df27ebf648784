#include "served/program_change.h"

#include "block/memory.h"
#include "station/translations.h"

namespace merker::served {
namespace {

// System data are no part of the program that runs.
bool fitsWorkMemory(const CpuModel& model, const block::Program& program) {
  std::size_t work = 0;
  for (const auto& [id, block] : program)
    if (id.kind != BlockKind::SDB) work += block::workMemory(block);
  return work <= model.workMemory;
}

// Here system data count as well.
bool fitsLoadMemory(const CpuModel& model, const block::Program& program) {
  std::size_t load = 0;
  for (const auto& [id, block] : program) load += block::loadMemory(block);
  return load <= model.loadMemory;
}

bool fits(const CpuModel& model, const block::Program& program) {
  return fitsWorkMemory(model, program) && fitsLoadMemory(model, program);
}

}  // namespace

void ProgramChange::makeReady() {
  if (error != s7comm::Error::None || !changesProgram()) return;
  auto program = std::make_shared<block::Program>(*before);
  for (const auto& block : linked) program->insert_or_assign(block->id, *block);
  for (const BlockId id : deleted) program->erase(id);
  if (!linked.empty() && !fits(*model, *program)) error = s7comm::Error::NoMemory;
  translations = std::make_shared<station::Translations>(*model, engine, program, before.get());
  after = std::move(program);
}

}  // namespace merker::served
