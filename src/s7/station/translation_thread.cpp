#include "station/translation_thread.h"

namespace merker::station {

void TranslationThread::begin(const CpuModel& model,
                              std::shared_ptr<const block::Program> program) {
  thread_ = std::jthread([this, &model, program = std::move(program)](const std::stop_token& stop) {
    made_ = std::make_unique<Translations>(model, Engine::Compiled, program, nullptr, stop);
    ready_ = true;
  });
}

std::unique_ptr<Translations> TranslationThread::take() {
  return ready_.exchange(false) ? std::move(made_) : nullptr;
}

}  // namespace merker::station
