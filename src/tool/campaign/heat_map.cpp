// A measure over two parameters: a field of colour for each pair of values.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/xml.h"
#include "campaign/picture.h"
#include "campaign/quantile.h"
#include "campaign/scale.h"
#include "scenario/plot.h"
#include "scenario/plot_style.h"

namespace merker::campaign {
namespace {

// Pixels.
constexpr double kMapLeft = 110, kMapTop = 72, kMapWidth = 640, kMapHeight = 400;
constexpr double kPictureWidth = 900, kPictureHeight = 540;
constexpr double kBarLeft = 780, kBarWidth = 22;
constexpr int kBarTicks = 6;
// More fields than that are too narrow for their numbers.
constexpr std::size_t kMostNumbers = 12;

struct Colour {
  double red, green, blue;
};
// Dark to light, in order also for those who do not see red or green, and in grey.
constexpr std::array kColours{Colour{68, 1, 84}, Colour{59, 82, 139}, Colour{33, 145, 140},
                              Colour{94, 201, 98}, Colour{253, 231, 37}};

Colour colourAt(double part) {
  const double place = std::clamp(part, 0.0, 1.0) * static_cast<double>(kColours.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kColours.size() - 2);
  const Colour &a = kColours[below], &b = kColours[below + 1];
  const auto mix = [rest = place - static_cast<double>(below)](double from, double to) {
    return from + rest * (to - from);
  };
  return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

std::string hex(const Colour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", std::lround(colour.red), std::lround(colour.green),
                     std::lround(colour.blue));
}

// Fields in rows from the lowest y to the highest.
struct Map {
  Scale x, y;
  std::vector<std::optional<double>> fields;
  double low = 0, high = 1;
  double width() const { return kMapWidth / static_cast<double>(x.places.size()); }
  double height() const { return kMapHeight / static_cast<double>(y.places.size()); }
  double part(double value) const { return (value - low) / (high - low); }
};

Map mapOf(const ResultTable& table, const HeatWish& wish) {
  Map map{scaleOf(table, wish.x), scaleOf(table, wish.y), {}};
  std::vector<std::vector<double>> values(map.x.places.size() * map.y.places.size());
  for (const ResultTable::Row& row : table.rows)
    if (const auto& value = row.measures[wish.measure])
      values[map.y.placeOf(row.parameters[wish.y]) * map.x.places.size() +
             map.x.placeOf(row.parameters[wish.x])]
          .push_back(*value);
  std::vector<double> all;
  for (std::vector<double>& field : values) {
    std::ranges::sort(field);
    map.fields.push_back(field.empty() ? std::nullopt : std::optional(quantile(field, 0.5)));
    if (map.fields.back()) all.push_back(*map.fields.back());
  }
  if (all.empty()) return map;
  std::ranges::sort(all);
  map.low = all.front();
  map.high = all.back() > all.front() ? all.back() : all.front() + 1;
  return map;
}

std::string field(const Map& map, std::size_t column, std::size_t row) {
  const auto& value = map.fields[row * map.x.places.size() + column];
  const double x = kMapLeft + static_cast<double>(column) * map.width();
  const double y = kMapTop + kMapHeight - static_cast<double>(row + 1) * map.height();
  std::string text = fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"/>", x, y,
      map.width() + 0.2, map.height() + 0.2,
      value ? hex(colourAt(map.part(*value))) : std::string("#e0e0e0"));
  if (!value || map.x.places.size() > kMostNumbers || map.y.places.size() > kMostNumbers)
    return text + "\n";
  return text + fmt::format(
                    "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" "
                    "style=\"fill:{}\">{:.4g}</text>\n",
                    x + map.width() / 2, y + map.height() / 2 + 4,
                    map.part(*value) > 0.6 ? "#000" : "#fff", *value);
}

// At most so many words along an axis that they do not meet.
std::size_t every(std::size_t places, std::size_t most) { return (places + most - 1) / most; }

std::string axes(const Map& map) {
  constexpr std::size_t kMostAcross = 12, kMostUp = 20;
  std::string text;
  for (std::size_t i = 0; i < map.x.places.size(); i += every(map.x.places.size(), kMostAcross))
    text += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
                        kMapLeft + (static_cast<double>(i) + 0.5) * map.width(),
                        kMapTop + kMapHeight + 18, xmlText(map.x.places[i].text));
  for (std::size_t i = 0; i < map.y.places.size(); i += every(map.y.places.size(), kMostUp))
    text += fmt::format("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", kMapLeft - 8,
                        kMapTop + kMapHeight - (static_cast<double>(i) + 0.5) * map.height() + 4,
                        xmlText(map.y.places[i].text));
  text += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>\n",
                      kMapLeft + kMapWidth, kMapTop + kMapHeight + 42, xmlText(map.x.name));
  return text + fmt::format("<text x=\"{}\" y=\"{}\">{}</text>\n", kMapLeft, kMapTop - 10,
                            xmlText(map.y.name));
}

// What the colours mean.
std::string bar(const Map& map) {
  constexpr int kSteps = 50;
  std::string text;
  for (int i = 0; i < kSteps; ++i)
    text += fmt::format("<rect x=\"{}\" y=\"{:.1f}\" width=\"{}\" height=\"{:.1f}\" fill=\"{}\"/>",
                        kBarLeft, kMapTop + kMapHeight * (1 - (i + 1.0) / kSteps), kBarWidth,
                        kMapHeight / kSteps + 0.2, hex(colourAt((i + 0.5) / kSteps)));
  const double step = simulator::niceStep(map.low, map.high, kBarTicks);
  for (double value = std::ceil(map.low / step - 1e-9) * step; value <= map.high + step / 1e6;
       value += step)
    text += fmt::format("\n<text x=\"{}\" y=\"{:.1f}\">{:g}</text>", kBarLeft + kBarWidth + 6,
                        kMapTop + kMapHeight * (1 - map.part(value)) + 4,
                        std::abs(value) < step / 1e6 ? 0 : value);
  return text + "\n";
}

}  // namespace

std::string drawHeatMap(const ResultTable& table, const HeatWish& wish) {
  const Map map = mapOf(table, wish);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\">\n{2}<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
      "<text class=\"title\" x=\"{3}\" y=\"24\">{4}</text>\n"
      "<text x=\"{3}\" y=\"42\">{5}: median of the runs</text>\n",
      kPictureWidth, kPictureHeight, simulator::kPlotStyle, kMapLeft, xmlText(wish.title),
      xmlText(table.measures[wish.measure]));
  for (std::size_t row = 0; row < map.y.places.size(); ++row)
    for (std::size_t column = 0; column < map.x.places.size(); ++column)
      text += field(map, column, row);
  return text + axes(map) + bar(map) + "</svg>\n";
}

}  // namespace merker::campaign
