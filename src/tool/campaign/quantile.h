// Quantiles of measured values.
#pragma once

#include <vector>

namespace merker::campaign {

// Of values in rising order, at least one; 0 <= p <= 1. Between two values linearly, the smallest
// and the largest are those of 0 and 1: type 7 of Hyndman and Fan, which R, NumPy and spreadsheets
// take.
double quantile(const std::vector<double>& sorted, double p);

}  // namespace merker::campaign
