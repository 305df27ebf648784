#include "project/subnet_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "base/text.h"
#include "project/readers.h"
#include "project/settings_view.h"

namespace merker::project {
namespace {

// Without a name a subnet is called as its kind (subnet_settings.cpp, dp_subnet_settings.cpp).
struct KindOfSubnet {
  std::string_view keyword, name;
};
constexpr KindOfSubnet kKindsOfSubnet[] = {
    {"mpi", "MPI"}, {"ethernet", "Ethernet"}, {"profibus", "PROFIBUS"}};

const KindOfSubnet& kindIn(const toml::table& subnet) {
  const std::string_view keyword = subnet["kind"].value_or(std::string_view());
  for (const KindOfSubnet& one : kKindsOfSubnet)
    if (equalsIgnoreCase(one.keyword, keyword)) return one;
  return kKindsOfSubnet[0];
}

std::string_view nameIn(const toml::table& subnet) {
  return subnet["name"].value_or(kindIn(subnet).name);
}

std::vector<const toml::table*> subnetsIn(const toml::table& root) {
  std::vector<const toml::table*> list;
  if (const toml::array* all = root["subnet"].as_array())
    for (const toml::node& one : *all)
      if (const toml::table* table = one.as_table()) list.push_back(table);
  return list;
}

const toml::table* subnetNamed(const toml::table& root, std::string_view name) {
  for (const toml::table* one : subnetsIn(root))
    if (nameIn(*one) == name) return one;
  return nullptr;
}

// A slave without a name of a subnet is on the only one (slave_settings.cpp).
std::vector<const toml::table*> slavesOn(const toml::table& root, std::string_view subnet) {
  std::vector<const toml::table*> list;
  if (const toml::array* all = root["slave"].as_array())
    for (const toml::node& one : *all)
      if (const toml::table* table = one.as_table())
        if (equalsIgnoreCase((*table)["subnet"].value_or(subnet), subnet)) list.push_back(table);
  return list;
}

// The place of the station in the list of nodes; as large as the list: it is not there.
std::size_t nodePlace(const toml::array& nodes, std::string_view station) {
  std::size_t place = 0;
  for (const toml::node& one : nodes) {
    const toml::table* node = one.as_table();
    if (node != nullptr && equalsIgnoreCase((*node)["station"].value_or(""), station)) break;
    ++place;
  }
  return place;
}

const toml::array* nodesOf(const toml::table& subnet) { return subnet["nodes"].as_array(); }

bool isNumber(std::string_view text) {
  return !text.empty() && text.size() < 10 &&
         text.find_first_not_of("0123456789") == std::string_view::npos;
}

std::string quoted(std::string_view text) { return fmt::format("\"{}\"", text); }

// What is no number is a text, and wrong where a number is wanted.
std::string addressText(std::string_view address) {
  return isNumber(address) ? std::string(address) : quoted(address);
}

std::string nodeText(std::string_view station, std::string_view address, const KindOfSubnet& kind) {
  const std::string rest = kind.keyword == "profibus" ? ", master = true" : "";
  return fmt::format("{{station = {}, address = {}}}", quoted(station),
                     addressText(address) + rest);
}

// The next one takes its place; behind the last one its comma stays, which TOML permits.
void takeOut(SettingsView& view, const toml::array& nodes, std::size_t place) {
  const toml::source_position from = nodes[place].source().begin;
  toml::source_position to = nodes.source().end;
  if (place + 1 < nodes.size())
    to = nodes[place + 1].source().begin;
  else
    --to.column;  // its bracket
  view.text().replace(from.line, from.column, to.line, to.column, "");
}

void addNode(SettingsView& view, const toml::table& subnet, const std::string& node) {
  const toml::array* nodes = nodesOf(subnet);
  if (nodes == nullptr || nodes->empty()) return view.set(subnet, "nodes", "[" + node + "]");
  const toml::source_position& end = nodes->back().source().end;
  view.text().replace(end.line, end.column, end.line, end.column, ", " + node);
}

}  // namespace

std::string SubnetEdit::kindOf(std::string_view subnet) const {
  const SettingsView view(text_);
  const toml::table* found = view.good() ? subnetNamed(view.root(), subnet) : nullptr;
  return std::string(found == nullptr ? "" : kindIn(*found).keyword);
}

std::vector<std::string> SubnetEdit::subnetsOf(std::string_view station,
                                               std::string_view kind) const {
  const SettingsView view(text_);
  std::vector<std::string> names;
  if (!view.good()) return names;
  for (const toml::table* one : subnetsIn(view.root())) {
    const toml::array* nodes = nodesOf(*one);
    if (kindIn(*one).keyword == kind && nodes != nullptr &&
        nodePlace(*nodes, station) < nodes->size())
      names.emplace_back(nameIn(*one));
  }
  return names;
}

void SubnetEdit::setNode(std::string_view subnet, std::string_view station,
                         std::string_view address) {
  SettingsView view(text_);
  const toml::table* found = view.good() ? subnetNamed(view.root(), subnet) : nullptr;
  if (found == nullptr) return;
  const toml::array* nodes = nodesOf(*found);
  const std::size_t place = nodes == nullptr ? 0 : nodePlace(*nodes, station);
  const bool there = nodes != nullptr && place < nodes->size();
  if (!there && !address.empty())
    addNode(view, *found, nodeText(station, address, kindIn(*found)));
  else if (there && address.empty())
    takeOut(view, *nodes, place);
  else if (there)
    view.set(*(*nodes)[place].as_table(), "address", addressText(address));
  text_ = view.text().text();
}

void SubnetEdit::set(std::string_view subnet, std::string_view key, const std::string& value) {
  SettingsView view(text_);
  const toml::table* found = view.good() ? subnetNamed(view.root(), subnet) : nullptr;
  if (found == nullptr) return;
  view.set(*found, key, value);
  text_ = view.text().text();
}

void SubnetEdit::remove(std::string_view subnet) {
  SettingsView view(text_);
  const toml::table* found = view.good() ? subnetNamed(view.root(), subnet) : nullptr;
  if (found == nullptr) return;
  std::vector<const toml::table*> tables;
  if (kindIn(*found).keyword == "profibus") tables = slavesOn(view.root(), subnet);
  tables.push_back(found);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> gone;  // first line, the one behind
  for (const toml::table* one : tables)
    gone.emplace_back(view.withComment(SettingsView::lineOf(*one)), view.behind(*one));
  // From the last one on: the lines of those above stay.
  std::ranges::sort(gone, std::greater());
  for (const auto& [first, behind] : gone) view.text().erase(first, behind);
  text_ = view.text().text();
}

}  // namespace merker::project
