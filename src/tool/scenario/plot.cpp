#include "scenario/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/xml.h"
#include "scenario/plot_style.h"

namespace merker::simulator {
namespace {

// Pixels.
constexpr double kWidth = 900, kLeft = 70, kRight = 20, kTop = 16, kTitle = 24, kBottom = 44;
constexpr double kRowHeight = 190, kBitHeight = 22, kGap = 30, kBitGap = 22;
constexpr int kTicks = 5, kTimeTicks = 10;
struct Range {
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
};

bool isBits(const PlotRow& row) {
  return std::all_of(row.begin(), row.end(), [](const PlotCurve& c) { return c.curve.binary; });
}

Range rangeOf(const PlotRow& row, const Plot& plot) {
  if (isBits(row)) return {0, 1};
  Range range;
  for (const PlotCurve& one : row)
    for (const Change& change : one.curve.changes) {
      if (change.seconds > plot.to || !std::isfinite(change.value)) continue;
      range.low = std::min(range.low, change.value);
      range.high = std::max(range.high, change.value);
    }
  if (range.low > range.high) return {0, 1};
  const double step = niceStep(range.low, range.high, kTicks);
  range.low = std::floor(range.low / step) * step;
  range.high = std::ceil(range.high / step) * step;
  if (range.low == range.high) range.high += step;
  return range;
}

// Where instants and values lie in the picture.
struct Frame {
  const Plot& plot;
  Range range;
  double top, height;
  double x(double seconds) const {
    const double part = (seconds - plot.from) / std::max(plot.to - plot.from, 1e-9);
    return kLeft + part * (kWidth - kLeft - kRight);
  }
  double y(double value) const {
    return top + height * (range.high - value) / (range.high - range.low);
  }
};

// The line of one curve as the points of a path: values stay until they change. A column of pixels
// gets its lowest, highest and last value only.
class Path {
 public:
  explicit Path(const Frame& frame) : frame_(frame) {}
  void go(double x, double value) {
    const double y = frame_.y(value);
    const auto column = static_cast<long>(x * 2);
    if (!begun_) {
      text_ = fmt::format("M{:.1f} {:.1f}", x, y);
    } else if (column == column_) {
      low_ = std::min(low_, y);
      high_ = std::max(high_, y);
      last_ = y;
      return;
    } else {
      flush();
      text_ += fmt::format("H{:.1f}V{:.1f}", x, y);
    }
    begun_ = true;
    column_ = column;
    drawn_ = low_ = high_ = last_ = y;
  }
  std::string end(double x) {
    flush();
    if (begun_) text_ += fmt::format("H{:.1f}", x);
    return text_;
  }

 private:
  void flush() {
    if (low_ < drawn_ || high_ > drawn_) text_ += fmt::format("V{:.1f}V{:.1f}", low_, high_);
    if (low_ < drawn_ || high_ > drawn_ || last_ != drawn_) text_ += fmt::format("V{:.1f}", last_);
  }
  const Frame& frame_;
  std::string text_;
  bool begun_ = false;
  long column_ = 0;
  double drawn_ = 0, low_ = 0, high_ = 0, last_ = 0;
};

std::string pathOf(const Curve& curve, const Frame& frame) {
  Path path(frame);
  const auto& changes = curve.changes;
  // Before its first change a bit had the other value.
  std::optional<double> before;
  if (curve.binary && !changes.empty()) before = 1 - changes.front().value;
  auto next = changes.begin();
  for (; next != changes.end() && next->seconds <= frame.plot.from; ++next) before = next->value;
  if (before) path.go(frame.x(frame.plot.from), *before);
  for (; next != changes.end() && next->seconds <= frame.plot.to; ++next)
    if (std::isfinite(next->value)) path.go(frame.x(next->seconds), next->value);
  return path.end(frame.x(frame.plot.to));
}

std::string valueAxis(const Frame& frame) {
  std::string text;
  const double step = niceStep(frame.range.low, frame.range.high, kTicks);
  const auto count = std::lround((frame.range.high - frame.range.low) / step);
  for (long i = 0; i <= count; ++i) {
    const double value = frame.range.low + static_cast<double>(i) * step;
    const double y = frame.y(value);
    text += fmt::format("<path class=\"grid\" d=\"M{} {:.1f}H{}\"/>", kLeft, y, kWidth - kRight);
    text += fmt::format("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{:g}</text>\n", kLeft - 8,
                        y + 4, std::abs(value) < step / 1e6 ? 0 : value);
  }
  return text;
}

std::string legend(const PlotRow& row, double y) {
  std::string text;
  double x = kLeft;
  for (std::size_t i = 0; i < row.size(); ++i) {
    text += fmt::format(
        "<text x=\"{:.0f}\" y=\"{:.1f}\" style=\"fill:{};font-weight:bold\">{}</text>\n", x, y,
        kPlotColours[i % kPlotColours.size()], xmlText(row[i].label));
    x += 24 + 7.5 * static_cast<double>(row[i].label.size());
  }
  return text;
}

std::string drawRow(const PlotRow& row, const Frame& frame) {
  std::string text = legend(row, frame.top - 6);
  if (!isBits(row)) text += valueAxis(frame);
  for (std::size_t i = 0; i < row.size(); ++i)
    text += fmt::format("<path class=\"curve\" stroke=\"{}\" d=\"{}\"/>\n",
                        kPlotColours[i % kPlotColours.size()], pathOf(row[i].curve, frame));
  return text;
}

std::string timeAxis(const Plot& plot, double bottom) {
  const Frame frame{plot, {0, 1}, 0, bottom};
  const double step = niceStep(plot.from, plot.to, kTimeTicks);
  std::string text =
      fmt::format("<path class=\"axis\" d=\"M{} {:.1f}H{}\"/>\n", kLeft, bottom, kWidth - kRight);
  for (double t = std::ceil(plot.from / step) * step; t <= plot.to + step / 1e6; t += step)
    text += fmt::format(
        "<path class=\"axis\" d=\"M{0:.1f} {1:.1f}v5\"/><text x=\"{0:.1f}\" y=\"{2:.1f}\" "
        "text-anchor=\"middle\">{3:g}</text>\n",
        frame.x(t), bottom, bottom + 18, std::abs(t) < step / 1e6 ? 0 : t);
  return text + fmt::format("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">t / s</text>\n",
                            kWidth - kRight, bottom + 34);
}

}  // namespace

double niceStep(double low, double high, int most) {
  const double least = std::max(high - low, std::abs(high) * 1e-6 + 1e-12) / most;
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least * (1 - 1e-9)) return factor * power;
  return 10 * power;
}

std::vector<PlotRow> rowsOf(const std::vector<Curve>& curves) {
  std::vector<PlotRow> rows;
  for (const Curve& curve : curves) rows.push_back({{curve, curve.operand}});
  return rows;
}

double endOf(const std::vector<Curve>& curves) {
  double end = 0;
  for (const Curve& curve : curves)
    if (!curve.changes.empty()) end = std::max(end, curve.changes.back().seconds);
  return end;
}

std::string drawSvg(const Plot& plot) {
  double y = kTop + (plot.title.empty() ? 0 : kTitle);
  std::string body;
  for (const PlotRow& row : plot.rows) {
    const double height = isBits(row) ? kBitHeight : kRowHeight;
    y += isBits(row) ? kBitGap : kGap;
    body += drawRow(row, {plot, rangeOf(row, plot), y, height});
    y += height;
  }
  y += kTop;
  body += timeAxis(plot, y);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1:.0f}\" "
      "viewBox=\"0 0 {0} {1:.0f}\">\n",
      kWidth, y + kBottom);
  text += kPlotStyle;
  text += "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  if (!plot.title.empty())
    text += fmt::format("<text class=\"title\" x=\"{}\" y=\"26\">{}</text>\n", kLeft,
                        xmlText(plot.title));
  return text + body + "</svg>\n";
}

}  // namespace merker::simulator
