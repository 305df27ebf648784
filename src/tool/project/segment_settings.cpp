// The cable of a subnet: repeaters and segments, and the rules of RS 485 (S7-NET-08, -09, -11, -12,
// -25).
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "base/text.h"
#include "project/readers.h"

namespace merker::project {
namespace {

constexpr std::size_t kMostPlaces = 32;  // nodes and repeaters of a segment (S7-NET-08)
constexpr std::uint32_t kLongestMetres = 1'000'000;

// The longest segment at a rate (S7-NET-25).
struct CableLimit {
  std::int64_t rate;  // bits per second, at most
  std::uint32_t metres;
};
constexpr CableLimit kCableLimits[] = {
    {187'500, 1000}, {500'000, 400}, {1'500'000, 200}, {12'000'000, 100}};

std::uint32_t longestCable(std::int64_t rate) {
  return std::ranges::find_if(kCableLimits, [&](const auto& one) { return rate <= one.rate; })
      ->metres;
}

// "40m"
std::optional<std::uint32_t> metres(std::string_view text) {
  std::uint32_t value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  const bool good = error == std::errc() && std::string_view(end, last) == "m";
  return good && value > 0 && value <= kLongestMetres ? std::optional(value) : std::nullopt;
}

// The segments of one subnet; who is where.
class Cable {
 public:
  Cable(const Table& table, const Network& network, Subnet& subnet)
      : table_(table), network_(network), subnet_(subnet) {}

  void readRepeaters() {
    const auto names = table_.texts("repeaters", "a list of names: [\"R1\"]");
    if (!names) return;
    if (names->size() > Table::kMostTables)
      return table_.mustBe("repeaters", fmt::format("at most {} names", Table::kMostTables));
    for (const Table::Text& name : *names) {
      if (nodeOf(name.text) != nullptr || isRepeater(name.text))
        refuse(name, "a name that no station and no other repeater has");
      else
        subnet_.repeaters.push_back(name.text);
    }
  }

  void add(const Table& table) {
    table.allow({"length", "nodes", "terminated"});
    Segment segment;
    readLength(table, segment);
    readPlaces(table, segment);
    checkPlaces(table, segment);
    checkTerminators(table, segment);
    subnet_.segments.push_back(std::move(segment));
  }

  // Everybody is connected, once, and a repeater on both sides.
  void finish() {
    for (const SubnetNode& node : subnet_.nodes)
      if (segmentsWith(nameOf(node)) != 1)
        table_.problems().add(ProblemCode::P0704, node.named, nameOf(node),
                              "in the nodes of one segment of its subnet");
    if (!isTree())
      table_.mustBe("segments",
                    "coupled to one tree by repeaters, each of them named in two segments");
  }

 private:
  const std::string& nameOf(const SubnetNode& node) const {
    return network_.stations[node.station].name;
  }
  const SubnetNode* nodeOf(std::string_view name) const {
    const auto found = std::ranges::find_if(subnet_.nodes, [&](const SubnetNode& node) {
      return equalsIgnoreCase(nameOf(node), name);
    });
    return found == subnet_.nodes.end() ? nullptr : &*found;
  }
  bool isRepeater(std::string_view name) const {
    return std::ranges::any_of(subnet_.repeaters, [&](const auto& one) { return one == name; });
  }
  void refuse(const Table::Text& text, std::string_view what) {
    table_.problems().add(ProblemCode::P0704, text.position, text.text, what);
  }

  void readLength(const Table& table, Segment& segment) {
    constexpr std::string_view kWhat = "a length in metres: \"40m\"";
    const auto text = table.text("length", kWhat);
    if (!text) return;
    const auto length = metres(*text);
    if (!length) return table.mustBe("length", kWhat);
    segment.length = *length;
    const std::uint32_t most = longestCable(subnet_.rate);
    if (*length > most)
      table.mustBe("length",
                   fmt::format("at most {} m at {} kbit/s; a repeater couples two segments", most,
                               static_cast<double>(subnet_.rate) / 1000));
  }

  void readPlaces(const Table& table, Segment& segment) {
    if (!table.has("nodes"))
      table.problems().add(ProblemCode::P0744, table.place(), table.title(),
                           "nodes = [\"Press\", \"Belt\"]");
    const auto names = table.texts("nodes", "a list of stations and repeaters");
    if (!names) return;
    for (const Table::Text& name : *names) {
      const SubnetNode* node = nodeOf(name.text);
      if (node != nullptr)
        segment.places.push_back(nameOf(*node));
      else if (isRepeater(name.text))
        segment.places.push_back(name.text);
      else
        refuse(name, "a station or a repeater of this subnet");
    }
  }

  void checkPlaces(const Table& table, const Segment& segment) {
    if (segment.places.size() > kMostPlaces)
      table.mustBe("nodes", fmt::format("at most {} with the repeaters; a repeater begins another "
                                        "segment",
                                        kMostPlaces));
    std::size_t grounded = 0, nodes = 0;
    for (const std::string& place : segment.places)
      if (const SubnetNode* node = nodeOf(place)) ++nodes, grounded += node->grounded ? 1 : 0;
    if (grounded != 0 && grounded != nodes)
      table.mustBe("nodes",
                   "all grounded or all ungrounded; a repeater couples segments of both kinds");
  }

  // On at both ends and nowhere else.
  void checkTerminators(const Table& table, const Segment& segment) {
    if (segment.places.empty()) return;
    std::vector<std::string> ends = {upper(segment.places.front())}, on;
    if (segment.places.size() > 1) ends.push_back(upper(segment.places.back()));
    const auto texts = table.texts("terminated", "a list of stations and repeaters");
    if (!texts && table.has("terminated")) return;
    if (texts)
      for (const Table::Text& text : *texts) on.push_back(upper(text.text));
    std::ranges::sort(ends);
    std::ranges::sort(on);
    if (on == ends) return;
    table.mustBe("terminated",
                 fmt::format("[\"{}\", \"{}\"]: the resistors are on at both ends of a segment and "
                             "nowhere else",
                             segment.places.front(), segment.places.back()));
  }

  std::size_t segmentsWith(const std::string& name) const {
    std::size_t count = 0;
    for (const Segment& segment : subnet_.segments)
      count += static_cast<std::size_t>(std::ranges::count(segment.places, name));
    return count;
  }

  // With one repeater less than segments, and each of them reached over repeaters.
  bool isTree() const {
    for (const std::string& repeater : subnet_.repeaters)
      if (segmentsWith(repeater) != 2) return false;
    std::vector<std::size_t> group(subnet_.segments.size());
    for (std::size_t i = 0; i < group.size(); ++i) group[i] = i;
    for (const std::string& repeater : subnet_.repeaters)
      if (!join(repeater, group)) return false;
    return std::ranges::all_of(group, [&](std::size_t one) { return one == group[0]; });
  }
  // False: both sides were connected already.
  bool join(const std::string& repeater, std::vector<std::size_t>& group) const {
    std::vector<std::size_t> sides;
    for (std::size_t i = 0; i < group.size(); ++i)
      if (std::ranges::count(subnet_.segments[i].places, repeater) > 0) sides.push_back(group[i]);
    if (sides.size() != 2 || sides[0] == sides[1]) return false;
    std::ranges::replace(group, sides[1], sides[0]);
    return true;
  }

  const Table& table_;
  const Network& network_;
  Subnet& subnet_;
};

}  // namespace

void readSegments(const Table& table, const Network& network, Subnet& subnet) {
  Cable cable(table, network, subnet);
  cable.readRepeaters();
  const auto segments = table.tables("segments");
  if (segments.empty()) {
    if (!subnet.repeaters.empty())
      table.mustBe("repeaters", "in the nodes of two segments; there are no segments");
    return;
  }
  for (const Table& segment : segments) cable.add(segment);
  cable.finish();
}

}  // namespace merker::project
