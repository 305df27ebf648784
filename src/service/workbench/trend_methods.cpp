// Curves of variables and of values of plants.
#include "workbench/method.h"

namespace merker::workbench {
namespace trend_methods {
namespace {

// Of a list; of all lists of a browser, which are read in each cycle; and the values that wait for
// it (8 bytes each).
constexpr std::size_t kMostCurves = 100, kCurves = 500, kWaitingValues = 500'000;

std::vector<std::string> namesOf(const Call& call) {
  std::vector<std::string> names;
  for (const Fields& item : call.fields.objects("items", kMostCurves))
    names.push_back(item.name("operand"));
  return names;
}

// Of the lists besides this one.
std::size_t curvesOf(const Browser& browser, std::int64_t number) {
  std::size_t count = 0;
  for (const auto& [other, trend] : browser.trends) count += other == number ? 0 : trend.curves();
  return count;
}

Answer set(const Call& call) {
  const auto number = call.fields.integer("list", 0, INT32_MAX);
  const auto every = call.fields.integer("everyMs", 0, 3'600'000, 0);
  std::vector<std::string> names = namesOf(call);
  if (!call.fields.good()) return call.fields.problems();
  auto& trends = call.browser.trends;
  if (!trends.contains(number) && trends.size() >= kLists)
    return refused(ProblemCode::P1314, kLists, "lists of curves");
  if (curvesOf(call.browser, number) + names.size() > kCurves)
    return refused(ProblemCode::P1314, kCurves, "curves of a browser");
  const auto [place, isNew] = trends.insert_or_assign(number, Trend(std::move(names), every));
  for (auto& [other, trend] : trends) trend.limit(kWaitingValues / trends.size());
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
}  // namespace trend_methods

std::span<const Method> trendMethods() { return trend_methods::kMethods; }

}  // namespace merker::workbench
