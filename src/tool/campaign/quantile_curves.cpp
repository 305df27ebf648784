// Curves of a measure over a parameter: the median as a line, around it two bands.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/xml.h"
#include "campaign/picture.h"
#include "campaign/quantile.h"
#include "campaign/scale.h"
#include "scenario/plot.h"
#include "scenario/plot_style.h"

namespace merker::campaign {
namespace {

using simulator::kPlotColours;

// Pixels.
constexpr double kWidth = 900, kHeight = 460, kLeft = 80, kRight = 20, kTop = 72, kBottom = 56;
constexpr int kTicksAcross = 10, kTicksUp = 8;

struct Band {
  double low, high, opacity;
};
constexpr std::array kBands{Band{0.05, 0.95, 0.15}, Band{0.25, 0.75, 0.3}};
// Of more curves the outer bands would lie over each other.
constexpr std::size_t kMostOuterBands = 2;

// Of one colour: the values at each place of x, sorted; places without values are left out.
struct Curve {
  std::string label;
  std::vector<std::pair<double, std::vector<double>>> points;
};

struct Frame {
  double left, right, low, high;  // of x and of the values
  double x(double value) const {
    return kLeft + (value - left) / (right - left) * (kWidth - kLeft - kRight);
  }
  double y(double value) const {
    return kTop + (high - value) / (high - low) * (kHeight - kTop - kBottom);
  }
};

// Where a place lies: numbers as they are, words one beside the other.
double at(const Scale& scale, std::size_t place) {
  return scale.numbers ? *scale.places[place].number : static_cast<double>(place);
}

std::vector<Curve> curvesOf(const ResultTable& table, const CurveWish& wish, const Scale& x) {
  Scale by;
  if (wish.by) by = scaleOf(table, *wish.by);
  std::vector<std::vector<std::vector<double>>> values(
      std::max<std::size_t>(by.places.size(), 1),
      std::vector<std::vector<double>>(x.places.size()));
  for (const ResultTable::Row& row : table.rows)
    if (const auto& value = row.measures[wish.measure])
      values[wish.by ? by.placeOf(row.parameters[*wish.by]) : 0][x.placeOf(row.parameters[wish.x])]
          .push_back(*value);
  std::vector<Curve> curves;
  for (std::size_t i = 0; i < values.size(); ++i) {
    Curve& curve = curves.emplace_back();
    curve.label =
        wish.by ? fmt::format("{} = {}", by.name, by.places[i].text) : table.measures[wish.measure];
    for (std::size_t place = 0; place < x.places.size(); ++place) {
      if (values[i][place].empty()) continue;
      std::ranges::sort(values[i][place]);
      curve.points.emplace_back(at(x, place), std::move(values[i][place]));
    }
  }
  return curves;
}

Frame frameOf(const std::vector<Curve>& curves, const Scale& x) {
  Frame frame{at(x, 0), at(x, x.places.size() - 1), INFINITY, -INFINITY};
  if (!x.numbers || frame.left == frame.right) {
    frame.left -= 0.5;
    frame.right += 0.5;
  }
  for (const Curve& curve : curves)
    for (const auto& [place, values] : curve.points) {
      frame.low = std::min(frame.low, quantile(values, kBands.front().low));
      frame.high = std::max(frame.high, quantile(values, kBands.front().high));
    }
  if (frame.low > frame.high) frame.low = frame.high = 0;
  const double step = simulator::niceStep(frame.low, frame.high, kTicksUp);
  frame.low = std::floor(frame.low / step) * step;
  frame.high = std::ceil(frame.high / step) * step;
  if (frame.low == frame.high) frame.high += step;
  return frame;
}

std::string tick(double value, double step) {
  return fmt::format("{:g}", std::abs(value) < step / 1e6 ? 0 : value);
}

std::string valueLines(const Frame& frame) {
  std::string text;
  const double step = simulator::niceStep(frame.low, frame.high, kTicksUp);
  for (double value = frame.low; value <= frame.high + step / 1e6; value += step)
    text += fmt::format(
        "<path class=\"grid\" d=\"M{0} {1:.1f}H{2}\"/><text x=\"{3}\" y=\"{4:.1f}\" "
        "text-anchor=\"end\">{5}</text>\n",
        kLeft, frame.y(value), kWidth - kRight, kLeft - 8, frame.y(value) + 4, tick(value, step));
  return text;
}

std::string mark(double x, std::string_view text) {
  const double y = kHeight - kBottom;
  return fmt::format(
      "<path class=\"axis\" d=\"M{0:.1f} {1}v5\"/><text x=\"{0:.1f}\" y=\"{2}\" "
      "text-anchor=\"middle\">{3}</text>\n",
      x, y, y + 18, xmlText(text));
}

std::string axisAcross(const Scale& x, const Frame& frame) {
  std::string text = fmt::format("<path class=\"axis\" d=\"M{} {}H{}\"/>\n", kLeft,
                                 kHeight - kBottom, kWidth - kRight);
  if (x.numbers && x.places.size() > 1) {
    const double step = simulator::niceStep(frame.left, frame.right, kTicksAcross);
    for (double value = std::ceil(frame.left / step - 1e-9) * step;
         value <= frame.right + step / 1e6; value += step)
      text += mark(frame.x(value), tick(value, step));
  } else {
    for (std::size_t i = 0; i < x.places.size(); ++i)
      text += mark(frame.x(at(x, i)), x.places[i].text);
  }
  return text + fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>\n",
                            kWidth - kRight, kHeight - 14, xmlText(x.name));
}

// There along the upper ends, back along the lower ones.
std::string bandPath(const Curve& curve, const Frame& frame, const Band& band) {
  std::string there, back;
  for (const auto& [place, values] : curve.points) {
    there += fmt::format("{}{:.1f} {:.1f}", there.empty() ? "M" : "L", frame.x(place),
                         frame.y(quantile(values, band.high)));
    back =
        fmt::format("L{:.1f} {:.1f}", frame.x(place), frame.y(quantile(values, band.low))) + back;
  }
  return there + back + "Z";
}

std::string drawCurve(const Curve& curve, const Frame& frame, std::span<const Band> bands,
                      std::string_view colour) {
  std::string text, line, dots;
  for (const Band& band : bands)
    text += fmt::format("<path fill=\"{}\" fill-opacity=\"{}\" d=\"{}\"/>\n", colour, band.opacity,
                        bandPath(curve, frame, band));
  for (const auto& [place, values] : curve.points) {
    const double x = frame.x(place), y = frame.y(quantile(values, 0.5));
    line += fmt::format("{}{:.1f} {:.1f}", line.empty() ? "M" : "L", x, y);
    dots +=
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\" fill=\"{}\"/>", x, y, colour);
  }
  return text +
         fmt::format("<path class=\"curve\" stroke=\"{}\" d=\"{}\"/>{}\n", colour, line, dots);
}

std::string legend(const std::vector<Curve>& curves, const std::string& measure) {
  std::string text =
      fmt::format("<text x=\"{}\" y=\"44\">{}: median, 25 to 75 %{} of the runs</text>\n", kLeft,
                  xmlText(measure), curves.size() > kMostOuterBands ? "" : " and 5 to 95 %");
  double x = kLeft;
  for (std::size_t i = 0; curves.size() > 1 && i < curves.size(); ++i) {
    text +=
        fmt::format("<text x=\"{:.0f}\" y=\"62\" style=\"fill:{};font-weight:bold\">{}</text>\n", x,
                    kPlotColours[i % kPlotColours.size()], xmlText(curves[i].label));
    x += 24 + 7.5 * static_cast<double>(curves[i].label.size());
  }
  return text;
}

}  // namespace

std::string drawQuantiles(const ResultTable& table, const CurveWish& wish) {
  const Scale x = scaleOf(table, wish.x);
  const std::vector<Curve> curves = curvesOf(table, wish, x);
  const Frame frame = frameOf(curves, x);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\">\n{2}<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
      "<text class=\"title\" x=\"{3}\" y=\"24\">{4}</text>\n",
      kWidth, kHeight, simulator::kPlotStyle, kLeft, xmlText(wish.title));
  text += legend(curves, table.measures[wish.measure]) + valueLines(frame) + axisAcross(x, frame);
  const auto bands = std::span(kBands).subspan(curves.size() > kMostOuterBands ? 1 : 0);
  for (std::size_t i = 0; i < curves.size(); ++i)
    if (!curves[i].points.empty())
      text += drawCurve(curves[i], frame, bands, kPlotColours[i % kPlotColours.size()]);
  return text + "</svg>\n";
}

}  // namespace merker::campaign
