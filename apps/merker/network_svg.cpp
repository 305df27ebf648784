// The drawing of a network: rows of stations, below each row the subnets as lines; a line that goes
// on in the next row runs down at the left.
#include <fmt/format.h>

#include <algorithm>

#include "base/xml.h"
#include "network_plan.h"

namespace merker::app {
namespace {

constexpr std::size_t kInARow = 8;
// Pixels
constexpr int kMargin = 24, kBoxWidth = 150, kBoxHeight = 62, kGap = 18, kLineGap = 34,
              kRowGap = 40;
constexpr int kLabel = 210;  // left of the lines: name and rate of the subnet
constexpr int kTextHeight = 22;

// The colours of NetPro.
struct KindColour {
  std::string_view kind, colour;
};
constexpr KindColour kKindColours[] = {
    {"mpi", "#c0392b"}, {"profibus", "#8e44ad"}, {"ethernet", "#1e8449"}, {"asi", "#b7950b"}};

std::string_view colourOf(std::string_view kind) {
  const auto* const found = std::ranges::find(kKindColours, kind, &KindColour::kind);
  return found == std::end(kKindColours) ? "#444444" : found->colour;
}

// "3"; of an IP address its last number, there is no room for more: ".3".
std::string shortAddress(const PlannedNode& node) {
  return fmt::format("{}{}", node.ip.empty() ? "" : ".", node.address);
}

class NetworkDrawing {
 public:
  explicit NetworkDrawing(const NetworkPlan& plan) : plan_(plan) {}

  std::string draw() {
    for (std::size_t first = 0; first < plan_.stations.size(); first += kInARow) row(first);
    trunks();
    legend();
    const std::size_t columns = std::min(kInARow, std::max<std::size_t>(plan_.stations.size(), 2));
    const int width = left(columns) + kMargin;
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\" role=\"img\" font-family=\"'DejaVu Sans',Arial,sans-serif\" "
        "font-size=\"13\">\n<title>{2}</title>\n<rect width=\"100%\" height=\"100%\" "
        "fill=\"#ffffff\"/>\n{3}</svg>\n",
        std::max(width, legendWidth_), y_ + kMargin, xmlText(plan_.name), out_);
  }

 private:
  static int left(std::size_t column) {
    return kLabel + kMargin + static_cast<int>(column) * (kBoxWidth + kGap);
  }
  int lineY(std::size_t subnet) const {
    return y_ + kBoxHeight + kLineGap * static_cast<int>(subnet + 1);
  }
  void text(int x, int y, std::string_view what, std::string_view more = "") {
    out_ += fmt::format("<text x=\"{}\" y=\"{}\"{}>{}</text>\n", x, y, more, xmlText(what));
  }
  void line(int x1, int y1, int x2, int y2, std::string_view colour, int width) {
    out_ += fmt::format(
        "<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" stroke=\"{}\" stroke-width=\"{}\"/>\n", x1,
        y1, x2, y2, colour, width);
  }

  void row(std::size_t first) {
    const std::size_t end = std::min(first + kInARow, plan_.stations.size());
    for (std::size_t i = 0; i < plan_.subnets.size(); ++i) subnetLine(i, first, end);
    for (std::size_t i = first; i < end; ++i) station(i, left(i - first));
    y_ += kBoxHeight + kLineGap * static_cast<int>(plan_.subnets.size()) + kRowGap;
  }

  // Drawn only where one of its nodes is, and named there.
  void subnetLine(std::size_t number, std::size_t first, std::size_t end) {
    const PlannedSubnet& subnet = plan_.subnets[number];
    const bool here = std::ranges::any_of(subnet.nodes, [&](const PlannedNode& node) {
      return node.station >= first && node.station < end;
    });
    if (!here && !(subnet.nodes.empty() && first == 0)) return;
    const int y = lineY(number);
    line(trunkX(number), y, left(end - first) - kGap, y, colourOf(subnet.kind), 5);
    lines_.push_back({number, y});
    text(kMargin, y - 8, subnet.name, " font-weight=\"bold\"");
    text(kMargin, y + 14, subnet.rate, " fill=\"#444444\"");
  }

  void station(std::size_t number, int x) {
    const PlannedStation& one = plan_.stations[number];
    out_ += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"4\" fill=\"#eef2f5\" "
        "stroke=\"#34495e\" stroke-width=\"1.5\"/>\n",
        x, y_, kBoxWidth, kBoxHeight);
    text(x + 10, y_ + 20, one.name, " font-weight=\"bold\"");
    text(x + 10, y_ + 38, one.model, " fill=\"#333333\" font-size=\"12\"");
    int port = x + 24;
    for (std::size_t i = 0; i < plan_.subnets.size(); ++i)
      for (const PlannedNode& node : plan_.subnets[i].nodes)
        if (node.station == number) interface(i, node, port), port += 44;
  }

  // The interface at the lower edge of the box, with its address.
  void interface(std::size_t subnet, const PlannedNode& node, int x) {
    const std::string_view colour = colourOf(plan_.subnets[subnet].kind);
    const int bottom = y_ + kBoxHeight;
    line(x, bottom, x, lineY(subnet), colour, 3);
    out_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"16\" height=\"12\" fill=\"{}\"/>\n", x - 8,
                        bottom - 12, colour);
    text(x + 6, bottom + 14, shortAddress(node), " font-size=\"12\"");
  }

  static int trunkX(std::size_t subnet) { return kLabel + 6 * static_cast<int>(subnet % 3); }
  // From the first to the last row of each subnet.
  void trunks() {
    for (std::size_t i = 0; i < plan_.subnets.size(); ++i) {
      int top = 0, bottom = 0;
      for (const auto& [subnet, y] : lines_)
        if (subnet == i) top = top == 0 ? y : top, bottom = y;
      if (bottom > top) line(trunkX(i), top, trunkX(i), bottom, colourOf(plan_.subnets[i].kind), 5);
    }
  }

  void legendLine(const std::string& what) {
    y_ += kTextHeight;
    text(kMargin, y_, what);
    constexpr int kCharacter = 8;
    legendWidth_ = std::max(legendWidth_, 2 * kMargin + kCharacter * static_cast<int>(what.size()));
  }
  void legend() {
    y_ -= kRowGap / 2;
    for (const project::GlobalDataRow& row : plan_.circles) legendLine(circleText(row));
    for (const PlannedConnection& one : plan_.connections)
      legendLine(fmt::format("{}: {} {} {}", nameOf(one), plan_.stations[one.station].name,
                             one.active ? "→" : "←", one.partner));
  }

  const NetworkPlan& plan_;
  int y_ = kMargin, legendWidth_ = 0;
  std::vector<std::pair<std::size_t, int>> lines_;  // of which subnet, where
  std::string out_;
};

}  // namespace

// A slave is drawn as a station is.
std::string toSvg(const NetworkPlan& plan) {
  NetworkPlan drawn = plan;
  for (PlannedSubnet& subnet : drawn.subnets)
    for (const compilation::PlannedSlave& slave : subnet.slaves) {
      subnet.nodes.push_back({drawn.stations.size(), slave.address});
      drawn.stations.push_back({slave.name, {}, slave.model});
    }
  return NetworkDrawing(drawn).draw();
}

}  // namespace merker::app
