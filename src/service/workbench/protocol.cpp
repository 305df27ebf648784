#include "workbench/protocol.h"

#include <algorithm>

namespace merker::workbench {
namespace {

struct Table {
  Shapes types, events;
  std::vector<MethodRow> methods;

  Table();
};

Table::Table() {
#define TYPE(name, fields, meaning) types.emplace(#name, fieldsShape(fields, types));
#define GROUP(title)
#define METHOD(name, needs, feature, kind, fields, result, meaning)                              \
  methods.push_back({name, Needs::State::needs, feature, Kind::kind, fieldsShape(fields, types), \
                     fieldsShape(result, types)});
#define EVENT(name, fields, meaning) events.emplace(name, fieldsShape(fields, types));
#include "workbench/protocol.def"
#undef TYPE
#undef GROUP
#undef METHOD
#undef EVENT
}

const Table& table() {
  static const Table rows;
  return rows;
}

// Besides its own fields; a line of a recording has its time.
constexpr std::string_view kOfEachRequest[] = {"id", "do", "at"};

}  // namespace

std::span<const MethodRow> methodRows() { return table().methods; }

const MethodRow* findMethodRow(std::string_view name) {
  const auto found = std::ranges::find(table().methods, name, &MethodRow::name);
  return found == table().methods.end() ? nullptr : &*found;
}

const Shape* eventShape(std::string_view name) {
  const auto found = table().events.find(name);
  return found == table().events.end() ? nullptr : &found->second;
}

std::optional<Problem> unknownField(const Method& method, const Json& request) {
  const MethodRow* row = findMethodRow(method.name);
  if (row == nullptr) return std::nullopt;  // protocol_test finds it
  return unknownField(row->fields, request, {}, kOfEachRequest);
}

}  // namespace merker::workbench
