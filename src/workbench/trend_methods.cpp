// Curves of variables and of values of plants.
#include "workbench/method.h"

namespace merker::workbench {
namespace {

constexpr std::size_t kMostCurves = 100;

std::vector<std::string> namesOf(const Call& call) {
  std::vector<std::string> names;
  for (const Fields& item : call.fields.objects("items", kMostCurves))
    names.push_back(item.text("operand"));
  return names;
}

Answer set(const Call& call) {
  const auto number = call.fields.integer("list", 0, INT32_MAX);
  const auto every = call.fields.integer("everyMs", 0, 3'600'000, 0);
  std::vector<std::string> names = namesOf(call);
  if (!call.fields.good()) return call.fields.problems();
  auto& trends = call.browser.trends;
  if (!trends.contains(number) && trends.size() >= kLists)
    return refused(ProblemCode::P1314, kLists, "lists of curves");
  const auto [place, isNew] = trends.insert_or_assign(number, Trend(std::move(names), every));
  return Json{{"items", place->second.describe(call.plc())}};
}

// What they would be, before anybody adds them.
Answer check(const Call& call) {
  Trend trend(namesOf(call), 0);
  if (!call.fields.good()) return call.fields.problems();
  return Json{{"items", trend.describe(call.plc())}};
}

Answer drop(const Call& call) {
  const auto number = call.fields.integer("list", 0, INT32_MAX);
  if (!call.fields.good()) return call.fields.problems();
  call.browser.trends.erase(number);
  return empty();
}

constexpr Method kMethods[] = {
    {"trend.set", Needs::Plc, set},
    {"trend.check", Needs::Plc, check},
    {"trend.drop", Needs::Nothing, drop},
};

}  // namespace

std::span<const Method> trendMethods() { return kMethods; }

}  // namespace merker::workbench
