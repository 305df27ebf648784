// Translations made in a thread of their own, for a PLC that has a cycle to keep.
#pragma once

#include <atomic>
#include <memory>
#include <thread>

#include "station/translations.h"

namespace merker::station {

class TranslationThread {
 public:
  bool begun() const { return thread_.joinable(); }
  void begin(const CpuModel& model, std::shared_ptr<const block::Program> program);
  // What was made, once; null: not yet.
  std::unique_ptr<Translations> take();

 private:
  std::unique_ptr<Translations> made_;
  std::atomic<bool> ready_ = false;
  std::jthread thread_;  // ends before what it writes to
};

}  // namespace merker::station
