#include "network_trace.h"

#include <algorithm>

namespace merker::app {
namespace {

template <typename List>
void append(List& to, const List& more) {
  to.insert(to.end(), more.begin(), more.end());
}

simulator::Watched ofStation(std::size_t station, const std::vector<StationWatched>& watched) {
  simulator::Watched all;
  for (const StationWatched& one : watched) {
    if (one.station != station) continue;
    append(all.operands, one.what.operands);
    append(all.plants, one.what.plants);
    append(all.terminals, one.what.terminals);
    append(all.axis, one.what.axis);
  }
  return all;
}

}  // namespace

void NetworkTrace::Column::take(Instant at) {
  if (text.view().empty()) return;
  lines.push_back({at, text.str()});
  text.str({});
}

NetworkTrace::NetworkTrace(std::ostream& out, network::Network& network,
                           const std::vector<StationWatched>& watched)
    : out_(out) {
  for (std::size_t i = 0; i < network.size(); ++i) {
    controller::Controller& plc = network.itself(i);
    Column& column = columns_.emplace_back();
    column.trace.emplace(column.text, ofStation(i, watched), plc);
    column.take(plc.now());
    plc.onCycle([&column](controller::Controller& moved) {
      column.trace->sample(moved);
      column.take(moved.now());
    });
  }
}

void NetworkTrace::write(Instant end) {
  std::vector<Line> due;
  for (Column& column : columns_)
    for (; !column.lines.empty() && column.lines.front().at < end; column.lines.pop_front())
      due.push_back(std::move(column.lines.front()));
  std::ranges::stable_sort(due, {}, &Line::at);
  for (const Line& line : due) out_ << line.text;
}

}  // namespace merker::app
