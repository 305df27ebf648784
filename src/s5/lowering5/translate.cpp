#include "lowering5/translate.h"

#include <array>
#include <map>

#include "lowering5/lowering.h"
#include "mc5/range.h"

namespace merker::translate5 {
namespace {

using mc5::Decoded;
using mc5::OperandKind;
using mc5::Operation;

// Executed in one go, if the clock cannot reach the horizon in it; shorter ones lose less when an
// event is near.
constexpr std::uint32_t kLongestRegion = 128;
constexpr std::size_t kDeepest = 16;  // brackets in a region

using Table = std::array<Lower, 256>;

Table makeTable() {
  Table table{};
  for (const auto rows :
       {bitRows(), moveRows(), numberRows(), jumpRows(), cellRows(), linkRows(), processingRows()})
    for (const Row& row : rows) table[static_cast<std::size_t>(row.operation)] = row.lower;
  return table;
}

Lower lowering(const Decoded& decoded) {
  static const Table kTable = makeTable();
  return kTable[static_cast<std::size_t>(decoded.instruction.operation)];
}

bool isOpening(Operation o) { return o == Operation::AND_OPEN || o == Operation::OR_OPEN; }

// The instructions of a block by their words.
class Listing {
 public:
  Listing(std::span<const std::uint16_t> code, const Target& target, const Substitutes& substitutes)
      : code_(code), target_(target), substitutes_(substitutes), isEntry_(code.size() + 1) {
    for (std::uint32_t at = 0; at < code.size();) at = take(at);
  }

  std::uint32_t length() const { return static_cast<std::uint32_t>(code_.size()); }
  // Null if there is none, or the processor would not execute it.
  const Decoded* at(std::uint32_t word) const {
    const auto found = instructions_.find(word);
    return found == instructions_.end() ? nullptr : &found->second;
  }
  bool isSubstitute(std::uint32_t word) const { return substitutes_.contains(word); }
  mc5::Times extra(std::uint32_t word) const {
    const auto found = substitutes_.find(word);
    return found == substitutes_.end() ? mc5::Times{} : found->second.extra;
  }
  bool isEntry(std::uint32_t word) const { return isEntry_[word]; }

 private:
  std::uint32_t take(std::uint32_t at) {
    auto decoded = mc5::decode(code_.subspan(at));
    if (!decoded) return at + 1;
    if (const auto found = substitutes_.find(at); found != substitutes_.end())
      decoded = found->second.decoded;
    const mc5::Operand& operand = decoded->instruction.operand;
    const std::uint32_t next = at + decoded->words;
    const bool timer = operand.kind == OperandKind::Timer;
    if (next > length()) return next;
    if (mc5::inRange(decoded->instruction) && !(timer && operand.value > target_.lastTimer))
      instructions_.emplace(at, *decoded);
    if (operand.kind == OperandKind::Jump) markEntry(at, operand.value);
    return callsFunctionBlock(*decoded) ? behindList(next) : next;
  }

  void markEntry(std::uint32_t at, std::uint32_t distance) {
    const std::int64_t to = std::int64_t{at} + static_cast<std::int32_t>(distance);
    if (to >= 0 && to < length()) isEntry_[static_cast<std::size_t>(to)] = true;
  }

  static bool callsFunctionBlock(const Decoded& decoded) {
    const mc5::Operand& operand = decoded.instruction.operand;
    return operand.kind == OperandKind::Block && operand.block == mc5::BlockType::Fb;
  }

  // A jump over the parameter list stands behind the call of an FB (S5-FB-06).
  std::uint32_t behindList(std::uint32_t at) {
    const auto jump = mc5::decode(code_.subspan(at));
    if (!jump || jump->instruction.operation != Operation::JUMP) return at;
    const auto distance = static_cast<std::int32_t>(jump->instruction.operand.value);
    if (distance <= 0) return at;
    instructions_.emplace(at, *jump);
    markEntry(at, static_cast<std::uint32_t>(distance));
    return at + static_cast<std::uint32_t>(distance);
  }

  std::span<const std::uint16_t> code_;
  const Target& target_;
  const Substitutes& substitutes_;
  std::map<std::uint32_t, Decoded> instructions_;
  std::vector<bool> isEntry_;
};

class Blockwise {
 public:
  Blockwise(std::span<const std::uint16_t> code, const Target& target,
            const std::vector<bool>& apart, const Substitutes& substitutes, const Sites* sites)
      : listing_(code, target, substitutes), target_(target), apart_(apart), sites_(sites) {}

  std::vector<icode::Region> run() {
    for (std::uint32_t at = 0; at < listing_.length();) at = region(at);
    return std::move(regions_);
  }

 private:
  struct Draft {
    explicit Draft(std::uint32_t first) { region.first = first; }
    icode::Region region;
    icode::Builder builder{region};
    std::vector<Bracket> brackets;
    bool ended = false, full = false;
    unsigned words = 0;  // of what was added last
  };

  bool mayFollow(const Draft& draft, std::uint32_t at) const {
    if (listing_.at(at) == nullptr || (at < apart_.size() && apart_[at])) return false;
    if (draft.region.instructions == 0 || !draft.brackets.empty()) return true;
    return !listing_.isEntry(at) && draft.region.instructions < kLongestRegion;
  }

  // What B would process, unless somebody looks at it.
  const Decoded* processed(std::uint32_t at) const {
    const bool seen = at < apart_.size() && apart_[at];
    return seen || listing_.isSubstitute(at) ? nullptr : listing_.at(at);
  }

  bool add(Draft& draft, std::uint32_t at) const {
    const Decoded& decoded = *listing_.at(at);
    const Lower lower = lowering(decoded);
    if (lower == nullptr || draft.brackets.size() >= kDeepest) return false;
    Lowering l{draft.builder,
               draft.region.needs,
               target_,
               decoded,
               at,
               listing_.length(),
               draft.brackets,
               processed(at + decoded.words),
               listing_.extra(at),
               sites_};
    draft.builder.begin(at, static_cast<std::uint64_t>(l.times().longest.ns));
    const bool done = lower(l);
    if (!done) draft.builder.cancel();
    draft.ended = l.ended;
    draft.full = l.leaves;
    draft.words = l.words == 0 ? decoded.words : l.words;
    return done;
  }

  // Whether a bracket that opens here comes to its end in a region: tried on a sheet of its own.
  bool closes(std::uint32_t at) const {
    Draft draft(at);
    do {
      if (!mayFollow(draft, at) || !add(draft, at)) return false;
      at += draft.words;
    } while (!draft.brackets.empty());
    return true;
  }

  // Returns where the next region may begin.
  std::uint32_t region(std::uint32_t at) {
    Draft draft(at);
    while (!draft.ended && !draft.full && mayFollow(draft, at)) {
      const Decoded& decoded = *listing_.at(at);
      const bool outermost = isOpening(decoded.instruction.operation) && draft.brackets.empty();
      if ((outermost && !closes(at)) || !add(draft, at)) break;
      at += draft.words;
    }
    if (draft.region.instructions == 0) return at + 1;
    if (!draft.ended) draft.builder.leave(at);
    regions_.push_back(std::move(draft.region));
    return at;
  }

  Listing listing_;
  const Target& target_;
  const std::vector<bool>& apart_;
  const Sites* sites_;
  std::vector<icode::Region> regions_;
};

}  // namespace

std::vector<icode::Region> translate(std::span<const std::uint16_t> code, const Target& target,
                                     const std::vector<bool>& apart, const Substitutes& substitutes,
                                     const Sites* sites) {
  return Blockwise(code, target, apart, substitutes, sites).run();
}

}  // namespace merker::translate5
