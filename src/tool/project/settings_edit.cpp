#include "project/settings_edit.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "project/files.h"
#include "project/path_pattern.h"
#include "project/readers.h"
#include "project/settings_view.h"

namespace merker::project {
namespace {

const toml::array* listOf(const toml::table& table, std::string_view key) {
  const toml::node* node = table.get(key);
  return node == nullptr ? nullptr : node->as_array();
}

ModulePlace placeOf(const toml::table& table) {
  const toml::node* slot = table.get("slot");
  const toml::node* rack = table.get("rack");
  const std::int64_t number = rack == nullptr ? 0 : rack->value<std::int64_t>().value_or(-1);
  return {static_cast<std::uint32_t>(number), slot == nullptr ? "" : slotText(*slot)};
}

const toml::table* moduleAt(const SettingsView& view, const ModulePlace& place) {
  const toml::array* modules = listOf(view.root(), "module");
  if (modules == nullptr) return nullptr;
  for (const toml::node& node : *modules)
    if (const auto* table = node.as_table(); table != nullptr && placeOf(*table) == place)
      return table;
  return nullptr;
}

std::string slotValue(const std::string& slot) {
  return slot.find('.') == std::string::npos ? slot : "\"" + slot + "\"";
}

// Before the plants, which come last in most files.
std::uint32_t endOfModules(const SettingsView& view) {
  if (const auto* modules = listOf(view.root(), "module"); modules && !modules->empty())
    return view.behind(*modules->back().as_table());
  const toml::array* plants = listOf(view.root(), "plant");
  return plants == nullptr || plants->empty()
             ? view.nextHeader(UINT32_MAX)
             : view.withComment(SettingsView::lineOf(*plants->front().as_table()));
}

// A table of its own, with a blank line on both sides.
void insertTable(SettingsText& text, std::uint32_t before, std::vector<std::string> lines) {
  if (before > 1 && !text.isBlank(before - 1)) lines.insert(lines.begin(), "");
  if (before <= text.lines() && !text.isBlank(before)) lines.emplace_back();
  text.insert(before, lines);
}

const toml::table* channelOf(const toml::table& module, std::string_view side,
                             std::uint32_t number) {
  const toml::array* channels = listOf(module, "channel");
  if (channels == nullptr) return nullptr;
  for (const toml::node& node : *channels) {
    const auto* table = node.as_table();
    const toml::node* key = table == nullptr ? nullptr : table->get(side);
    if (key != nullptr && key->value<std::int64_t>() == number) return table;
  }
  return nullptr;
}

const toml::table* tableOf(const toml::table& root, std::string_view path) {
  const toml::table* table = &root;
  while (table != nullptr && !path.empty()) {
    const auto point = path.find('.');
    const toml::node* node = table->get(path.substr(0, point));
    table = node == nullptr ? nullptr : node->as_table();
    path.remove_prefix(point == std::string_view::npos ? path.size() : point + 1);
  }
  return table;
}

constexpr std::string_view kFileLists[] = {"sources", "symbols"};

const toml::array* fileList(const SettingsView& view, std::string_view key) {
  const toml::table* program = tableOf(view.root(), "program");
  return program == nullptr ? nullptr : listOf(*program, key);
}

std::string inQuotes(std::string_view path) { return fmt::format("\"{}\"", path); }

// The entry that names exactly this file.
const toml::node* entryOf(const toml::array& list, std::string_view path) {
  for (const toml::node& node : list)
    if (const auto* text = node.as_string(); text != nullptr && text->get() == path) return &node;
  return nullptr;
}

bool finds(const toml::array& list, std::string_view path) {
  const std::string name = upper(path);
  std::uint64_t steps = 0;
  return std::any_of(list.begin(), list.end(), [&](const toml::node& node) {
    return node.is_string() && PathPattern(node.as_string()->get()).matches(name, steps);
  });
}

void append(SettingsView& view, const toml::array& list, std::string_view path) {
  const toml::source_position& end = list.back().source().end;
  view.text().replace(end.line, end.column, end.line, end.column, ", " + inQuotes(path));
}

void renameIn(SettingsView& view, const toml::array& list, std::string_view from,
              std::string_view to) {
  if (const toml::node* entry = entryOf(list, from)) {
    const toml::source_region& place = entry->source();
    view.text().replace(place.begin.line, place.begin.column, place.end.line, place.end.column,
                        inQuotes(to));
  } else if (finds(list, from) && !finds(list, to)) {
    append(view, list, to);
  }
}

// The list that this file would stand in.
std::string_view listFor(std::string_view path) {
  constexpr std::pair<std::string_view, std::string_view> kEndings[] = {
      {".awl", "sources"}, {".mc7", "sources"}, {".s5", "sources"},  {".sym", "symbols"},
      {".sdf", "symbols"}, {".asc", "symbols"}, {".dif", "symbols"}, {".seq", "symbols"}};
  for (const auto& [ending, key] : kEndings)
    if (hasExtension(path, ending)) return key;
  return {};
}

std::string listWithout(const toml::array& list, std::string_view path) {
  std::string text;
  for (const toml::node& node : list)
    if (const auto* entry = node.as_string(); entry != nullptr && entry->get() != path)
      text += (text.empty() ? "" : ", ") + inQuotes(entry->get());
  return "[" + text + "]";
}

// A table below a module: [module.serial].
bool hasHeaders(const SettingsView& view, const toml::table& module) {
  return std::all_of(module.begin(), module.end(), [&](const auto& one) {
    return !one.second.is_table() || view.hasHeader(*one.second.as_table());
  });
}

bool writtenAsTables(const SettingsView& view) {
  const toml::node* modules = view.root().get("module");
  if (modules == nullptr) return true;
  const auto* list = modules->as_array();
  return list != nullptr && std::all_of(list->begin(), list->end(), [&](const toml::node& one) {
           return one.is_table() && view.hasHeader(*one.as_table()) &&
                  hasHeaders(view, *one.as_table());
         });
}

}  // namespace

SettingsEdit::SettingsEdit(std::string file, std::string text) : file_(std::move(file)) {
  take(std::move(text));
}

void SettingsEdit::take(std::string text) {
  text_ = std::move(text);
  const SettingsView view(text_);
  problem_.reset();
  if (deepKey(text_)) {
    problem_ = makeProblem(ProblemCode::P0202, Position{file_}, "the nesting of keys",
                           fmt::format("1..{}", kDeepestKey));
  } else if (!view.good()) {
    const toml::source_position& place = view.error().source().begin;
    problem_ = makeProblem(ProblemCode::P0702, Position{file_, place.line, place.column},
                           std::string(view.error().description()));
  } else if (!writtenAsTables(view)) {
    problem_ =
        makeProblem(ProblemCode::P1308, Position{file_}, file_,
                    "only modules written as [[module]] and [module.serial] can be changed here");
  }
}

bool SettingsEdit::has(const ModulePlace& place) const {
  const SettingsView view(text_);
  return view.good() && project::moduleAt(view, place) != nullptr;
}

void SettingsEdit::add(const ModulePlace& place, std::string_view type) {
  SettingsView view(text_);
  std::vector<std::string> lines = {"[[module]]"};
  if (place.rack != 0) lines.push_back(fmt::format("rack = {}", place.rack));
  lines.push_back(fmt::format("slot = {}", slotValue(place.slot)));
  if (!type.empty()) lines.push_back(fmt::format("type = \"{}\"", type));
  insertTable(view.text(), endOfModules(view), std::move(lines));
  take(view.text().text());
}

void SettingsEdit::addPlant(std::string_view name, std::string_view kind, const Pairs& parameters,
                            const Pairs& wires) {
  SettingsView view(text_);
  std::vector<std::string> lines = {"[[plant]]"};
  const auto add = [&](const Pairs& pairs) {
    for (const auto& [key, value] : pairs) lines.push_back(fmt::format("{} = {}", key, value));
  };
  add({{"name", std::string(name)}, {"kind", std::string(kind)}});
  add(parameters);
  if (!wires.empty()) lines.insert(lines.end(), {"", "[plant.wire]"});
  add(wires);
  insertTable(view.text(), view.text().lines() + 1, std::move(lines));
  take(view.text().text());
}

void SettingsEdit::addTable(std::string_view title, const Pairs& values) {
  SettingsView view(text_);
  std::vector<std::string> lines = {fmt::format("[[{}]]", title)};
  for (const auto& [key, value] : values) lines.push_back(fmt::format("{} = {}", key, value));
  insertTable(view.text(), view.text().lines() + 1, std::move(lines));
  take(view.text().text());
}

void SettingsEdit::remove(const ModulePlace& place) {
  SettingsView view(text_);
  const toml::table* module = project::moduleAt(view, place);
  if (module == nullptr) return;
  const std::uint32_t behind = view.behind(*module);
  view.text().erase(view.withComment(SettingsView::lineOf(*module)), behind);
  take(view.text().text());
}

void SettingsEdit::move(const ModulePlace& place, const ModulePlace& to) {
  if (to.rack != place.rack) set(place, "rack", to.rack == 0 ? Value() : std::to_string(to.rack));
  set({to.rack, place.slot}, "slot", slotValue(to.slot));
}

void SettingsEdit::set(const ModulePlace& place, std::string_view key, const Value& value) {
  SettingsView view(text_);
  const toml::table* module = project::moduleAt(view, place);
  if (module == nullptr) return;
  const auto point = key.find('.');
  const std::string_view inner = key.substr(0, point);
  if (point == std::string_view::npos)
    view.set(*module, key, value);
  else if (const toml::table* below = tableOf(*module, inner))
    view.set(*below, key.substr(point + 1), value);
  else if (value)
    insertTable(
        view.text(), view.behind(*module),
        {fmt::format("[module.{}]", inner), fmt::format("{} = {}", key.substr(point + 1), *value)});
  take(view.text().text());
}

void SettingsEdit::setChannel(const ModulePlace& place, std::string_view side, std::uint32_t number,
                              std::string_view key, const Value& value) {
  SettingsView view(text_);
  const toml::table* module = project::moduleAt(view, place);
  if (module == nullptr) return;
  if (const toml::table* channel = channelOf(*module, side, number))
    view.set(*channel, key, value);
  else if (value)
    insertTable(view.text(), view.behind(*module),
                {"[[module.channel]]", fmt::format("{} = {}", side, number),
                 fmt::format("{} = {}", key, *value)});
  take(view.text().text());
}

std::vector<std::string> SettingsEdit::channelKeys(const ModulePlace& place, std::string_view side,
                                                   std::uint32_t number) const {
  std::vector<std::string> keys;
  SettingsView view(text_);
  const toml::table* module = project::moduleAt(view, place);
  const toml::table* channel = module == nullptr ? nullptr : channelOf(*module, side, number);
  if (channel == nullptr) return keys;
  for (const auto& [key, value] : *channel) keys.emplace_back(key.str());
  return keys;
}

void SettingsEdit::setIn(std::string_view name, std::string_view key, const Value& value) {
  SettingsView view(text_);
  const toml::table* table = tableOf(view.root(), name);
  if (table != nullptr && view.hasHeader(*table)) {
    view.set(*table, key, value);
  } else if (value) {
    const toml::table* outer = tableOf(view.root(), name.substr(0, name.find('.')));
    const std::uint32_t before = outer != nullptr && view.hasHeader(*outer)
                                     ? view.lastLine(SettingsView::lineOf(*outer)) + 1
                                     : endOfModules(view);
    insertTable(view.text(), before,
                {fmt::format("[{}]", name), fmt::format("{} = {}", key, *value)});
  }
  take(view.text().text());
}

void SettingsEdit::renameFile(std::string_view from, std::string_view to) {
  for (const std::string_view key : kFileLists) {
    SettingsView view(text_);
    const toml::array* list = view.good() ? fileList(view, key) : nullptr;
    if (list == nullptr || list->empty()) continue;
    renameIn(view, *list, from, to);
    take(view.text().text());
  }
}

void SettingsEdit::removeFile(std::string_view path) {
  for (const std::string_view key : kFileLists) {
    const SettingsView view(text_);
    const toml::array* list = view.good() ? fileList(view, key) : nullptr;
    if (list != nullptr && entryOf(*list, path) != nullptr)
      setIn("program", key, listWithout(*list, path));
  }
}

bool SettingsEdit::addFile(std::string_view path) {
  const std::string_view key = listFor(path);
  SettingsView view(text_);
  const toml::array* list = view.good() && !key.empty() ? fileList(view, key) : nullptr;
  if (list == nullptr || finds(*list, path)) return false;
  if (list->empty()) {
    setIn("program", key, "[" + inQuotes(path) + "]");
  } else {
    append(view, *list, path);
    take(view.text().text());
  }
  return true;
}

std::vector<ModuleLines> SettingsEdit::modules() const {
  const SettingsView view(text_);
  const toml::array* modules = view.good() ? listOf(view.root(), "module") : nullptr;
  std::vector<ModuleLines> list;
  if (modules == nullptr) return list;
  for (const toml::node& node : *modules)
    if (const auto* table = node.as_table())
      list.push_back({SettingsView::lineOf(*table), view.behind(*table), placeOf(*table)});
  std::ranges::sort(list, {}, &ModuleLines::first);
  return list;
}

}  // namespace merker::project
