#include "step5/jump_targets.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "step5/call_list.h"

namespace merker::step5 {
namespace {

struct FoundJump {
  std::uint32_t from = 0, target = 0;
};

class TargetFinder {
 public:
  TargetFinder(const mc5::Program& program, const mc5::Block& block)
      : program_(program), block_(block) {}

  std::map<std::uint32_t, std::string> find() {
    for (std::uint32_t at = 0; at < block_.words.size();) at = instruction(at);
    labels_ = block_.labels;
    for (const auto& [word, label] : labels_) taken_.insert(label);
    for (const FoundJump& jump : jumps_)
      if (starts_.contains(jump.target) && sameNetwork(block_, jump.from, jump.target))
        name(jump.target);
    return std::move(labels_);
  }

 private:
  std::uint32_t instruction(std::uint32_t at) {
    starts_.insert(at);
    const auto decoded = mc5::decode(std::span(block_.words).subspan(at));
    if (!decoded) return at + 1;
    const mc5::Operand& operand = decoded->instruction.operand;
    if (operand.kind == mc5::OperandKind::Jump) jumps_.push_back({at, at + operand.value});
    const auto list = callList(program_, block_, decoded->instruction, at + decoded->words);
    return list ? list->end : at + decoded->words;
  }

  void name(std::uint32_t word) {
    if (labels_.contains(word)) return;
    std::string label;
    do label = fmt::format("M{:03}", ++made_);
    while (!taken_.insert(label).second);
    labels_[word] = label;
  }

  const mc5::Program& program_;
  const mc5::Block& block_;
  std::set<std::uint32_t> starts_;
  std::vector<FoundJump> jumps_;
  std::map<std::uint32_t, std::string> labels_;
  std::set<std::string> taken_;
  unsigned made_ = 0;
};

// The network that a word lies in. BLD 255 in front of a network ends the one before.
std::size_t networkOf(const mc5::Block& block, std::uint32_t word) {
  const auto& networks = block.networks;  // their offsets ascend
  const auto behind = std::upper_bound(
      networks.begin(), networks.end(), word,
      [](std::uint32_t at, const mc5::Network& network) { return at < network.offset; });
  const bool first = !networks.empty() && networks.front().offset == 0;
  return static_cast<std::size_t>(behind - networks.begin()) - (first ? 1 : 0);
}

}  // namespace

std::map<std::uint32_t, std::string> jumpTargets(const mc5::Program& program,
                                                 const mc5::Block& block) {
  return TargetFinder(program, block).find();
}

bool sameNetwork(const mc5::Block& block, std::uint32_t a, std::uint32_t b) {
  return networkOf(block, a) == networkOf(block, b);
}

}  // namespace merker::step5
