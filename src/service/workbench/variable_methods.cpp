// Values: watch lists, reading once, modifying, forcing (S7-SIM-12).
#include "workbench/method.h"
#include "workbench/trigger_field.h"
#include "workbench/wishes.h"

namespace merker::workbench {
namespace variable_methods {
namespace {

std::vector<WatchItem> items(const Call& call) {
  std::vector<WatchItem> list;
  for (const Fields& item : call.fields.objects("items", kItems)) list.push_back(watchItem(item));
  return list;
}

Answer watch(const Call& call) {
  const auto number = call.fields.integer("list", 0, INT32_MAX);
  if (!call.fields.good()) return call.fields.problems();
  // A list that is refused leaves none: its values would pass for those of the one before.
  call.browser.lists.erase(number);
  const auto every = call.fields.integer("everyMs", 0, 60'000, 33);
  const auto trigger =
      call.plc().can(monitor::Feature::CyclePoints) ? triggerOf(call.fields) : std::nullopt;
  auto wanted = items(call);
  if (!call.fields.good()) return call.fields.problems();
  auto& lists = call.browser.lists;
  if (lists.size() >= kLists) return refused(ProblemCode::P1314, kLists, "lists");
  constexpr std::int64_t kNone = -1;
  if (trigger && pointItems(call.browser, number, kNone) + wanted.size() > kPointItems)
    return refused(ProblemCode::P1314, kPointItems, "operands at trigger points");
  WatchList list(std::move(wanted), every, trigger);
  WatchExtent all = watched(call.browser);
  all += list.extent();
  if (all.items > kWatched) return refused(ProblemCode::P1314, kWatched, "watched operands");
  if (all.bytes > kWatchedBytes)
    return refused(ProblemCode::P1314, kWatchedBytes, "bytes in the names of watched operands");
  const auto [place, isNew] = lists.emplace(number, std::move(list));
  return Json{{"items", place->second.describe(call.plc())}};
}

Answer drop(const Call& call) {
  const auto number = call.fields.integer("list", 0, INT32_MAX);
  if (!call.fields.good()) return call.fields.problems();
  call.browser.lists.erase(number);
  return empty();
}

Json unknown(const Problem& problem) {
  return {{"text", "?"}, {"raw", nullptr}, {"problem", toJson(problem)}};
}

Json readOne(const Plc& plc, const WatchItem& item) {
  if (item.problem) return unknown(*item.problem);
  const auto reference = plc.operand(item.operand);
  if (!reference) return unknown(reference.error());
  if (const auto problem = monitor::checkFormat(*reference, item.format)) return unknown(*problem);
  const auto value = plc.read(*reference);
  if (!value) return unknown(makeProblem(ProblemCode::P1213, nowhere(), item.operand));
  return {{"text", monitor::show(*reference, *value, item.format)},
          {"raw", rawValue(*reference, *value, item.format)}};
}

Answer read(const Call& call) {
  const auto wanted = items(call);
  if (!call.fields.good()) return call.fields.problems();
  Json list = Json::array();
  for (const WatchItem& item : wanted) list.push_back(readOne(call.plc(), item));
  return Json{{"items", std::move(list)}};
}

// Of the CPU: all browsers are told them with each change. An S7-318 has 256, the others fewer.
constexpr std::size_t kMostForces = 500;

Answer write(const Call& call) {
  const Wishes wishes(call.fields);
  const bool held = call.fields.flag("held", false), each = call.fields.flag("each", false);
  if (!call.fields.good()) return call.fields.problems();
  std::vector<monitor::Wish> list = wishes.list();
  HeldBits& bits = call.browser.heldBits;
  if (held && bits.size() + list.size() > kItems)
    return refused(ProblemCode::P1314, kItems, "held operands");
  Json without = Json::array();
  if (each)
    without = leaveOut(list, [&](const auto& wish) { return call.monitor().write({wish}); });
  else if (auto problem = call.monitor().write(list))
    return one(std::move(*problem));
  std::vector<address::Reference> written;
  for (const monitor::Wish& wish : list)
    if (auto reference = call.plc().operand(wish.operand)) written.push_back(std::move(*reference));
  bits.note(written, held);
  return Json{{"refused", std::move(without)}};
}

Answer force(const Call& call) {
  const Wishes wishes(call.fields);
  if (!call.fields.good()) return call.fields.problems();
  if (call.monitor().forces().size() + wishes.list().size() > kMostForces)
    return refused(ProblemCode::P1314, kMostForces, "forced operands");
  return done(call.monitor().force(wishes.list()));
}

Answer unforce(const Call& call) {
  if (!call.fields.has("items")) return call.monitor().unforceAll(), empty();
  std::vector<std::string> names;
  for (const Fields& item : call.fields.objects("items", kItems))
    names.push_back(item.name("operand"));
  if (!call.fields.good()) return call.fields.problems();
  return done(call.monitor().unforce({names.begin(), names.end()}));
}

constexpr Method kMethods[] = {
    {"watch.set", Needs::Plc, watch},
    {"watch.drop", Needs::Nothing, drop},
    {"variables.read", Needs::Plc, read},
    {"variables.write", Needs::PlcOn, write, Kind::Action},
    {"variables.force", Needs::PlcOn, force, Kind::Action},
    {"variables.unforce", Needs::PlcOn, unforce, Kind::Action},
};

}  // namespace
}  // namespace variable_methods

std::span<const Method> variableMethods() { return variable_methods::kMethods; }

}  // namespace merker::workbench
