// Modifying at a trigger point.
#include "workbench/method.h"
#include "workbench/trigger_field.h"
#include "workbench/wishes.h"

namespace merker::workbench {

std::optional<monitor::Trigger> triggerOf(const Fields& fields) {
  constexpr monitor::CyclePoint kPoints[] = {monitor::CyclePoint::Begin, monitor::CyclePoint::End,
                                             monitor::CyclePoint::Stop};
  constexpr std::size_t kNow = 3;
  const std::size_t point = fields.choice("point", {"begin", "end", "stop", "now"}, kNow);
  const bool once = fields.flag("once", false);
  if (point == kNow) return std::nullopt;
  return monitor::Trigger{kPoints[point], once};
}

namespace modify_methods {
namespace {

using monitor::Feature;

Answer set(const Call& call) {
  const auto number = call.fields.integer("list", 0, INT32_MAX);
  const auto trigger = triggerOf(call.fields);
  const Wishes wishes(call.fields);
  const bool each = call.fields.flag("each", false);
  if (!call.fields.good()) return call.fields.problems();
  if (!trigger) {
    const ProblemCode code = call.fields.has("point") ? ProblemCode::P1305 : ProblemCode::P1306;
    return refused(code, "point", "one of \"begin\", \"end\", \"stop\"");
  }
  auto& lists = call.browser.modifies;
  if (!lists.contains(number) && lists.size() >= kLists)
    return refused(ProblemCode::P1314, kLists, "lists");
  std::vector<monitor::Wish> wanted = wishes.list();
  Json without = Json::array();
  if (each)
    without = leaveOut(wanted, [&](const auto& wish) -> std::optional<Problem> {
      const auto change = call.monitor().inCycle(wish);
      return change ? std::nullopt : std::optional(change.error());
    });
  auto list = ModifyList::of(call.monitor(), wanted, *trigger);
  if (!list) return one(list.error());
  constexpr std::int64_t kNone = -1;
  if (pointItems(call.browser, kNone, number) + list->size() > kPointItems)
    return refused(ProblemCode::P1314, kPointItems, "operands at trigger points");
  lists.insert_or_assign(number, std::move(list.value()));
  return Json{{"refused", std::move(without)}};
}

Answer drop(const Call& call) {
  const auto number = call.fields.integer("list", 0, INT32_MAX);
  if (!call.fields.good()) return call.fields.problems();
  call.browser.modifies.erase(number);
  return empty();
}

constexpr Method kMethods[] = {
    {"modify.set", Needs::ableOn(Feature::CyclePoints), set},
    {"modify.drop", Needs::Nothing, drop},
};

}  // namespace
}  // namespace modify_methods

std::span<const Method> modifyMethods() { return modify_methods::kMethods; }

}  // namespace merker::workbench
