#include "workbench/process_rows.h"

namespace merker::workbench {
namespace {

using plant::Signal;

bool isWritable(const plant::PlantSettings& settings, std::uint32_t signal) {
  return settings.kind->signals[signal].side == Signal::Side::Input &&
         settings.wireOf(signal) == nullptr;
}

// What is wired can be stuck: a sensor shows, an actuator does the same from then on.
Json stuckRow(const plant::Plants& plants, plant::SignalPlace place, const Signal& signal) {
  return {{"name", signal.name},
          {"title", fmt::format("{} stuck", signal.name)},
          {"on", plants.stuck(place).has_value()}};
}

}  // namespace

Json plantRows(const plant::Plants& plants) {
  Json list = Json::array();
  const auto& all = plants.configuration().plants;
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    Json values = Json::array(), faults = Json::array();
    for (std::uint32_t s = 0; s < all[i].kind->signals.size(); ++s) {
      const Signal& signal = all[i].kind->signals[s];
      values.push_back({{"name", signal.name},
                        {"unit", signal.unit},
                        {"value", plants.value({i, s})},
                        {"writable", isWritable(all[i], s)},
                        {"min", signal.binary ? 0 : signal.low},
                        {"max", signal.binary ? 1 : signal.high}});
      if (all[i].wireOf(s) != nullptr) faults.push_back(stuckRow(plants, {i, s}, signal));
    }
    list.push_back({{"name", all[i].name},
                    {"kind", all[i].kind->name},
                    {"title", all[i].name},
                    {"values", std::move(values)},
                    {"faults", std::move(faults)}});
  }
  return list;
}

Json plantValues(const plant::Plants& plants) {
  Json result = Json::object();
  const auto& all = plants.configuration().plants;
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    Json& values = result[all[i].name] = Json::object();
    for (std::uint32_t s = 0; s < all[i].kind->signals.size(); ++s)
      values[std::string(all[i].kind->signals[s].name)] = plants.value({i, s});
  }
  return result;
}

}  // namespace merker::workbench
