#include "served/system_blocks.h"

#include <map>
#include <mutex>

#include "system/library.h"

namespace merker::served {
namespace {

block::Program functionsOf(const CpuModel& model) {
  block::Program all = system::library(model);
  std::erase_if(all, [](const auto& one) {
    return one.first.kind != BlockKind::SFC && one.first.kind != BlockKind::SFB;
  });
  return all;
}

}  // namespace

const block::Program& systemBlocks(const CpuModel& model) {
  static std::mutex mutex;
  static std::map<std::string_view, block::Program> known;  // by keyword; rows of the catalogue
  const std::lock_guard lock(mutex);
  const auto found = known.find(model.keyword);
  if (found != known.end()) return found->second;
  return known.emplace(model.keyword, functionsOf(model)).first->second;
}

}  // namespace merker::served
