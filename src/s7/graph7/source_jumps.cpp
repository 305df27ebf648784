#include "graph7/source_jumps.h"

namespace merker::graph7 {

using graph::OperandKind;
using graph::SourceNetwork;

void Labels::add(std::string_view name, const std::vector<SourceNetwork>& networks) {
  labels_.try_emplace(std::string(name),
                      Place{networks.size() - 1, networks.back().statements.size()});
}

void Labels::jump(const std::vector<SourceNetwork>& networks) {
  jumps_.push_back({networks.size() - 1, networks.back().statements.size() - 1});
}

// A label behind the last statement of a network is one of the next.
Labels::Place Labels::following(Place place, const std::vector<SourceNetwork>& networks) {
  while (place.network < networks.size() &&
         place.statement >= networks[place.network].statements.size())
    place = {place.network + 1, 0};
  return place;
}

// As network_code.cpp: jumps of other networks, and all but SPBNB of the same one, may only lead to
// a beginning. A label that is nowhere may still be written.
void Labels::resolve(std::vector<SourceNetwork>& networks) const {
  for (const auto& [name, at] : labels_)
    if (const Place place = following(at, networks); place.statement == 0 &&
                                                     place.network < networks.size() &&
                                                     networks[at.network].labelLine == 0)
      networks[place.network].label = name;
  for (const Place& at : jumps_) {
    graph::Statement& jump = networks[at.network].statements[at.statement];
    const auto label = labels_.find(jump.operand.text);
    if (label == labels_.end()) continue;
    const Place to = following(label->second, networks);
    const bool box = jump.op == graph::Op::SPBNB && to.network == at.network;
    if (box && to.statement > at.statement) {
      jump.target = static_cast<std::int32_t>(to.statement);
      jump.operand.code.clear();
    } else if (to.network == networks.size() || to.statement > 0) {
      jump.operand.kind = OperandKind::Forbidden;
      if (!box && to.network < networks.size())
        networks[to.network].statements[to.statement].intruded = true;
    }
  }
}

}  // namespace merker::graph7
