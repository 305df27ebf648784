// Curves over time as a picture in SVG: rows below each other over one axis of time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenario/curves.h"

namespace merker::simulator {

struct PlotCurve {
  Curve curve;
  std::string label;
};
// Curves over one axis of values; a row of bits is drawn low and flat.
using PlotRow = std::vector<PlotCurve>;

struct Plot {
  std::string title;
  std::vector<PlotRow> rows;
  double from = 0, to = 0;  // seconds
};

// Each bit has a row of its own; so has each curve that is none.
std::vector<PlotRow> rowsOf(const std::vector<Curve>& curves);
// The last instant of all curves.
double endOf(const std::vector<Curve>& curves);

std::string drawSvg(const Plot& plot);

// Steps of 1, 2 or 5 times a power of ten, at most `most` of them between the ends.
double niceStep(double low, double high, int most);

}  // namespace merker::simulator
