#include "together.h"

#include <thread>

namespace merker::bench {
namespace {

void advance(std::vector<station::Station>& stations, std::size_t first, std::size_t end,
             Duration by) {
  constexpr Duration kSlice = Duration::seconds(1);
  for (Duration gone{}; gone < by; gone = gone + kSlice)
    for (std::size_t i = first; i < end; ++i) stations[i].advanceTo(stations[i].now() + kSlice);
}

}  // namespace

void advanceTogether(std::vector<station::Station>& stations, Duration by) {
  const std::size_t middle = stations.size() / 2;
  std::thread half([&] { advance(stations, 0, middle, by); });
  advance(stations, middle, stations.size(), by);
  half.join();
}

}  // namespace merker::bench
