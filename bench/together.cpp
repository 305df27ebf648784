#include "together.h"

namespace merker::bench {
namespace {

std::vector<network::Station> stations(std::size_t count,
                                       const std::function<station::Station()>& make) {
  std::vector<network::Station> all;
  for (std::size_t i = 0; i < count; ++i)
    all.push_back({std::to_string(i), std::make_unique<station::Station>(make())});
  return all;
}

}  // namespace

Together::Together(std::size_t count, const std::function<station::Station()>& make)
    : network_(stations(count, make), 2) {}

station::Station& Together::station(std::size_t i) {
  return static_cast<station::Station&>(network_.itself(i));
}

}  // namespace merker::bench
