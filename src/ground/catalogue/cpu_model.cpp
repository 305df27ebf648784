#include "catalogue/cpu_model.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace merker {
namespace {

std::string normalised(std::string_view text) {
  std::string result;
  for (const char c : text)
    if (c != ' ') result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result.starts_with("cpu") ? result.substr(3) : result;
}

}  // namespace

bool CpuModel::hasOrganizationBlock(unsigned number) const {
  return std::find(organizationBlocks.begin(), organizationBlocks.end(), number) !=
         organizationBlocks.end();
}

bool CpuModel::allows(BlockId id) const {
  switch (id.kind) {
    case BlockKind::OB:
      return id.number != 0 && hasOrganizationBlock(id.number);
    case BlockKind::DB:
      return id.number != 0 && id.number <= highestDb;
    case BlockKind::FB:
      return id.number <= highestFb;
    case BlockKind::FC:
      return id.number <= highestFc;
    case BlockKind::SDB:
    case BlockKind::PB:  // of STEP 5
    case BlockKind::SB:
      return false;
    case BlockKind::UDT:
    case BlockKind::SFC:
    case BlockKind::SFB:
      return true;
  }
  return false;
}

const CpuModel& defaultCpuModel() { return cpuModels().front(); }

const CpuModel* findCpuModel(std::string_view name) {
  const std::string wanted = normalised(name);
  for (const CpuModel& model : cpuModels())
    if (wanted == normalised(model.keyword) || wanted == normalised(model.name)) return &model;
  return nullptr;
}

}  // namespace merker
