#include "softplc/sinumerik_model.h"

#include <array>
#include <cctype>

namespace merker {
namespace {

constexpr std::array kModels{
    SinumerikModel{"SINUMERIK 810 GA3", true},
    SinumerikModel{"SINUMERIK 820 GA3", true},
    SinumerikModel{"SINUMERIK 810 GA3 COP", false},
    SinumerikModel{"SINUMERIK 820 GA3 COP", false},
};

std::string normalised(std::string_view text) {
  std::string result;
  for (const char c : text)
    if (c != ' ' && c != '-')
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

}  // namespace

std::span<const SinumerikModel> sinumerikModels() { return kModels; }
const SinumerikModel& defaultSinumerikModel() { return kModels.front(); }

const SinumerikModel* findSinumerikModel(std::string_view name) {
  const std::string wanted = normalised(name);
  for (const SinumerikModel& model : kModels)
    if (normalised(model.name) == wanted) return &model;
  return nullptr;
}

std::string sinumerikModelNames() {
  std::string list;
  for (const SinumerikModel& model : kModels)
    list.append(list.empty() ? "" : ", ").append(model.name);
  return list;
}

}  // namespace merker
