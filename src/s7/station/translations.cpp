#include "station/translations.h"

#include "cpu/same_code.h"
#include "station/mixed_engine.h"
#include "station/station.h"

namespace merker::station {
namespace {

bool isCode(BlockKind kind) {
  return kind == BlockKind::OB || kind == BlockKind::FB || kind == BlockKind::FC;
}

bool isIn(const block::Program* program, const block::Block& block) {
  if (program == nullptr) return false;
  const auto found = program->find(block.id);
  return found != program->end() && cpu::sameCode(found->second, block);
}

}  // namespace

Translations::Translations(const CpuModel& model, Engine engine,
                           std::shared_ptr<const block::Program> program,
                           const block::Program* before, const std::stop_token& stop)
    : program_(std::move(program)) {
  MixedEngine mixed(model, engine == Engine::Compiled);
  compiled_ = mixed.compiles();
  for (const auto& [id, block] : *program_) {
    if (stop.stop_requested()) return;
    if (isCode(id.kind) && block.checks.empty() && !isIn(before, block))
      blocks_.emplace(id, mixed.translate(block));
  }
  BlockCopies copies([this](bool functionBlock, std::uint32_t number) {
    const auto found = blocks_.find(
        {functionBlock ? BlockKind::FB : BlockKind::FC, static_cast<std::uint16_t>(number)});
    return found == blocks_.end()
               ? nullptr
               : static_cast<const interpreter::Translated*>(found->second.get());
  });
  for (const auto& [id, code] : blocks_) {
    if (stop.stop_requested()) return;
    mixed.link(static_cast<interpreter::Translated&>(*code), copies);
  }
}

cpu::Code* Translations::find(const block::Block& block) const {
  const auto found = blocks_.find(block.id);
  if (found == blocks_.end()) return nullptr;
  const block::Block& source = *found->second->source;
  return &source == &block || cpu::sameCode(source, block) ? found->second.get() : nullptr;
}

std::unique_ptr<cpu::Code> Translations::take(const block::Block& block) {
  if (find(block) == nullptr) return nullptr;
  std::unique_ptr<cpu::Code> code = std::move(blocks_.extract(block.id).mapped());
  code->source = &block;
  return code;
}

}  // namespace merker::station
