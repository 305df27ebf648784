#define TOML_EXCEPTIONS 0
#include "project/settings.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <array>

#include "address/constant.h"
#include "base/bcd.h"

namespace merker::project {
namespace {

constexpr std::int64_t kMillisecondsPerDay = 24 * 3600 * 1000;

class Reader {
 public:
  Reader(const std::string& file, Settings& settings, Problems& problems)
      : file_(file), settings_(settings), problems_(problems) {}
  void read(const toml::table& root);

 private:
  using Handler = void (Reader::*)(const toml::node&, const toml::source_region&);
  struct Key {
    std::string_view name;
    Handler handler;
  };
  struct Section {
    std::string_view name;
    std::vector<Key> keys;
  };
  static const std::array<Section, 3>& sections();

  Position at(const toml::source_region& region, std::size_t length = 1) const;
  void readSection(const Section& section, const toml::table& table);
  std::optional<std::string> text(const toml::node& node, const toml::source_region& at,
                                  std::string_view key, std::string_view what);
  std::optional<std::vector<Pattern>> patterns(const toml::node& node,
                                               const toml::source_region& at, std::string_view key);

  void name(const toml::node& node, const toml::source_region& at);
  void sources(const toml::node& node, const toml::source_region& at);
  void symbols(const toml::node& node, const toml::source_region& at);
  void model(const toml::node& node, const toml::source_region& at);
  void clock(const toml::node& node, const toml::source_region& at);

  const std::string& file_;
  Settings& settings_;
  Problems& problems_;
};

const std::array<Reader::Section, 3>& Reader::sections() {
  static const std::array<Section, 3> kSections = {
      Section{"project", {{"name", &Reader::name}}},
      Section{"program", {{"sources", &Reader::sources}, {"symbols", &Reader::symbols}}},
      Section{"cpu", {{"model", &Reader::model}, {"clock", &Reader::clock}}}};
  return kSections;
}

template <typename Rows>
std::string names(const Rows& rows) {
  std::string list;
  for (const auto& row : rows) list += fmt::format("{}{}", list.empty() ? "" : ", ", row.name);
  return list;
}

template <typename Rows>
auto find(const Rows& rows, std::string_view name) -> decltype(&*rows.begin()) {
  for (const auto& row : rows)
    if (row.name == name) return &row;
  return nullptr;
}

Position Reader::at(const toml::source_region& region, std::size_t length) const {
  return {file_, region.begin.line, region.begin.column, static_cast<std::uint32_t>(length)};
}

void Reader::read(const toml::table& root) {
  for (const auto& [key, node] : root) {
    const Section* section = find(sections(), key.str());
    const toml::source_region& place = key.source();
    if (!section)
      problems_.add(ProblemCode::P0703, at(place, key.str().size()), key.str(), file_,
                    names(sections()));
    else if (const toml::table* table = node.as_table())
      readSection(*section, *table);
    else
      problems_.add(ProblemCode::P0704, at(place, key.str().size()), key.str(),
                    "a table: [" + std::string(key.str()) + "]");
  }
}

void Reader::readSection(const Section& section, const toml::table& table) {
  for (const auto& [key, node] : table) {
    if (const Key* known = find(section.keys, key.str()))
      (this->*known->handler)(node, node.source());
    else
      problems_.add(ProblemCode::P0703, at(key.source(), key.str().size()), key.str(),
                    fmt::format("[{}]", section.name), names(section.keys));
  }
}

std::optional<std::string> Reader::text(const toml::node& node, const toml::source_region& place,
                                        std::string_view key, std::string_view what) {
  if (const auto* string = node.as_string()) return string->get();
  problems_.add(ProblemCode::P0704, at(place), key, what);
  return std::nullopt;
}

std::optional<std::vector<Pattern>> Reader::patterns(const toml::node& node,
                                                     const toml::source_region& place,
                                                     std::string_view key) {
  constexpr std::string_view kWhat =
      "a list of file names or patterns: [\"*.awl\", \"lib/**/*.awl\"]";
  const toml::array* array = node.as_array();
  if (!array) {
    problems_.add(ProblemCode::P0704, at(place), key, kWhat);
    return std::nullopt;
  }
  std::vector<Pattern> list;
  for (const toml::node& element : *array)
    if (auto pattern = text(element, element.source(), key, kWhat))
      list.push_back({*pattern, at(element.source(), pattern->size() + 2)});
  return list;
}

void Reader::name(const toml::node& node, const toml::source_region& place) {
  if (auto value = text(node, place, "name", "a text")) settings_.name = *value;
}

void Reader::sources(const toml::node& node, const toml::source_region& place) {
  settings_.sources = patterns(node, place, "sources");
}

void Reader::symbols(const toml::node& node, const toml::source_region& place) {
  settings_.symbols = patterns(node, place, "symbols");
}

void Reader::model(const toml::node& node, const toml::source_region& place) {
  const auto value = text(node, place, "model", "the name of a CPU");
  if (!value) return;
  if (const CpuModel* model = findCpuModel(*value))
    settings_.model = model;
  else
    problems_.add(ProblemCode::P0705, at(place, value->size() + 2), *value, modelNames());
}

// Two BCD digits of a DATE_AND_TIME, counted from its first byte.
unsigned digits(std::uint64_t bcd, int byte) {
  const auto value = static_cast<std::uint32_t>(bcd >> (8 * (7 - byte)) & 0xFF);
  return fromBcd(value, 2).value_or(0);
}

std::int64_t millisecondsSince1990(std::uint64_t bcd) {
  const int year = static_cast<int>(digits(bcd, 0));
  const auto days =
      daysSince1990(year < 90 ? 2000 + year : 1900 + year, static_cast<int>(digits(bcd, 1)),
                    static_cast<int>(digits(bcd, 2)));
  const std::int64_t seconds = (digits(bcd, 3) * 60LL + digits(bcd, 4)) * 60 + digits(bcd, 5);
  const std::int64_t ms = digits(bcd, 6) * 10LL + (bcd >> 4 & 0xF);
  return days.value_or(0) * kMillisecondsPerDay + seconds * 1000 + ms;
}

void Reader::clock(const toml::node& node, const toml::source_region& place) {
  const auto value = text(node, place, "clock", "a text like \"DT#2005-03-01-08:00:00\"");
  if (!value) return;
  const auto bcd = parseDateAndTime(*value, at(place, value->size() + 2));
  if (bcd)
    settings_.startOfClock = millisecondsSince1990(bcd.value());
  else
    problems_.add(bcd.error());
}

}  // namespace

std::string modelNames() {
  std::string list;
  for (const CpuModel& model : cpuModels())
    list += fmt::format("{}{}", list.empty() ? "" : ", ", model.keyword);
  return list;
}

std::int64_t defaultStartOfClock() {
  return daysSince1990(1994, 1, 1).value_or(0) * kMillisecondsPerDay;
}

Settings readSettings(const source::SourceFile& file, Problems& problems) {
  Settings settings;
  settings.startOfClock = defaultStartOfClock();
  const toml::parse_result result = toml::parse(file.text(), file.name());
  if (!result) {
    const toml::source_position& place = result.error().source().begin;
    problems.add(ProblemCode::P0702, Position{file.name(), place.line, place.column},
                 std::string(result.error().description()));
    return settings;
  }
  Reader(file.name(), settings, problems).read(result.table());
  return settings;
}

}  // namespace merker::project
