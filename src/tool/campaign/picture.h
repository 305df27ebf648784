// Results of a campaign as a picture in SVG.
#pragma once

#include <optional>
#include <string>

#include "campaign/table.h"

namespace merker::campaign {

// What the options of `merker plot` say; empty: chosen by the table.
struct PictureWish {
  std::string title, x, y, by, heat;
};

// With --heat a map of this measure over two parameters, else curves of a measure over one. Names
// are checked against the table (P0787); `path` is the file's.
Result<std::string> draw(const ResultTable& table, const PictureWish& wish,
                         const std::string& path);

// Positions in the table.
struct CurveWish {
  std::string title;
  std::size_t x, measure;
  std::optional<std::size_t> by;  // a curve for each of its values
};
// Median, the middle half and nine tenths of all runs at each place.
std::string drawQuantiles(const ResultTable& table, const CurveWish& wish);

struct HeatWish {
  std::string title;
  std::size_t x, y, measure;
};
// The median of all runs in each field.
std::string drawHeatMap(const ResultTable& table, const HeatWish& wish);

}  // namespace merker::campaign
