// Curves of variables and of values of plants.
#include "workbench/method.h"
#include "workbench/wishes.h"

namespace merker::workbench {
namespace trend_methods {
namespace {

// Of a list; of all lists of a browser, which are read in each cycle; and the values that wait for
// it (8 bytes each).
constexpr std::size_t kMostCurves = 100, kCurves = 500, kWaitingValues = 500'000;

struct Wanted {
  std::vector<std::string> names;
  std::map<std::size_t, Problem> problems;  // of those that can be no name, which is empty then

  explicit Wanted(const Call& call) {
    for (const Fields& item : call.fields.objects("items", kMostCurves)) {
      WatchItem one = watchItem(item);
      if (one.problem) problems.emplace(names.size(), *one.problem);
      names.push_back(std::move(one.operand));
    }
  }
  Json told(Json items) const {
    for (const auto& [item, problem] : problems) items[item]["problem"] = toJson(problem);
    return {{"items", std::move(items)}};
  }
};

std::size_t curvesOf(const Browser& browser) {
  std::size_t count = 0;
  for (const auto& [number, trend] : browser.trends) count += trend.curves();
  return count;
}

Answer set(const Call& call) {
  const auto number = call.fields.integer("list", 0, INT32_MAX);
  if (!call.fields.good()) return call.fields.problems();
  auto& trends = call.browser.trends;
  trends.erase(number);  // a list that is refused leaves none
  const auto every = call.fields.integer("everyMs", 0, 3'600'000, 0);
  Wanted wanted(call);
  if (!call.fields.good()) return call.fields.problems();
  if (trends.size() >= kLists) return refused(ProblemCode::P1314, kLists, "lists of curves");
  if (curvesOf(call.browser) + wanted.names.size() > kCurves)
    return refused(ProblemCode::P1314, kCurves, "curves of a browser");
  const auto [place, isNew] = trends.emplace(number, Trend(wanted.names, every));
  for (auto& [other, trend] : trends) trend.limit(kWaitingValues / trends.size());
  return wanted.told(place->second.describe(call.plc()));
}

// What they would be, before anybody adds them.
Answer check(const Call& call) {
  const Wanted wanted(call);
  if (!call.fields.good()) return call.fields.problems();
  return wanted.told(Trend(wanted.names, 0).describe(call.plc()));
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
