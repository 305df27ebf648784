#include "lowering/translate.h"

#include <algorithm>
#include <array>
#include <optional>

#include "lowering/callees.h"
#include "lowering/copying.h"
#include "lowering/lowering.h"

namespace merker::translate {
namespace {

using icode::Item;
using mc7::Operation;

constexpr std::size_t kOperations = 256;
// So many instructions of a block are translated once more because loops lead to them again.
constexpr std::uint32_t kRepeated = 4096;
// So many instructions of other blocks are translated with a block that calls them, and so many
// for each of its own.
constexpr std::uint32_t kCopied = 256, kCopiesOf = 8;

using Table = std::array<Lower, kOperations>;

Table makeTable() {
  Table table{};
  for (const auto rows : {bitRows(), moveRows(), numberRows(), shiftRows(), realRows(), jumpRows(),
                          callRows(), timerRows(), bcdRows()})
    for (const Row& row : rows) table[static_cast<std::size_t>(row.operation)] = row.lower;
  return table;
}

const Table& table() {
  static const Table rows = makeTable();
  return rows;
}

class Blockwise {
 public:
  Blockwise(const mc7::Listing& listing, const CpuModel& model, const Context& context)
      : listing_(listing),
        model_(model),
        context_(context),
        longest_(context.longest),
        shapes_(context.find),
        copied_(kCopied + kCopiesOf * static_cast<std::uint32_t>(listing.places.size())),
        isEntry_(listing.places.size() + 1),
        inLoop_(listing.places.size() + 1) {}

  std::vector<icode::Region> run() {
    markEntries();
    const auto count = static_cast<std::uint32_t>(listing_.places.size());
    for (std::uint32_t at = 0; at < count;) at = region(at);
    return std::move(regions_);
  }

 private:
  // Nothing: no jump, or it leads out of the block.
  std::optional<std::uint32_t> target(std::uint32_t at) const {
    const mc7::Place& place = listing_.places[at];
    if (!place.known || place.instruction.operand.kind != mc7::OperandKind::Jump)
      return std::nullopt;
    const auto to = static_cast<std::uint32_t>(listing_.target(place));
    return to < isEntry_.size() ? std::optional(to) : std::nullopt;
  }

  // A jump to the next instruction, as over a list of parameters, makes no entry. One that leads
  // back may be followed; then the way behind it is an exit.
  void markEntries() {
    std::vector<int> change(inLoop_.size() + 1);
    for (std::uint32_t at = 0; at < listing_.places.size(); ++at) {
      const auto to = target(at);
      if (!to || *to == at + 1) continue;
      isEntry_[*to] = 1;
      if (*to > at) continue;
      isEntry_[at + 1] = 1;
      ++change[*to], --change[at + 1];
    }
    int depth = 0;
    for (std::size_t at = 0; at < inLoop_.size(); ++at) inLoop_[at] = (depth += change[at]) > 0;
  }

  // Once more in a region that came here by way of a loop: as far as to the next place at which
  // another region begins, or not at all.
  bool repeats(const icode::Region& region, std::uint32_t at) {
    if (!inLoop_[region.first] || !inLoop_[at]) return false;
    const std::uint32_t room = std::min(spare_, longest_ - std::min(region.instructions, longest_));
    std::uint32_t count = 0;
    do {
      count += 1 + copiedBy(at);
      if (count > room) return false;
    } while (isEntry_[++at] == 0);
    spare_ -= count;
    return true;
  }

  // The jump here leads back to where this region can go on.
  bool follows(const icode::Region& region, std::uint32_t at) {
    const auto to = target(at);
    return to && *to <= at && repeats(region, *to);
  }

  // What the instruction in front leaves in any case, by its row.
  void knowFromBefore(icode::Builder& builder, std::uint32_t first) const {
    if (first == 0 || isEntry_[first] != 0 || !listing_.places[first - 1].known) return;
    const std::string_view status =
        mc7::info(listing_.places[first - 1].instruction.operation).status;
    constexpr struct {
      std::size_t column;
      Item item;
    } kColumns[] = {{5, Item::Or}, {6, Item::Sta}, {8, Item::Er}};
    for (const auto& [column, item] : kColumns)
      if (status[column] == '0' || status[column] == '1') builder.know(item, status[column] == '1');
  }

  // How far a region has come.
  struct Walk {
    std::uint32_t at;
    bool ended = false, jumped = false;
    std::optional<std::uint32_t> behind{};  // its own instructions, where it repeats others
    std::vector<std::array<icode::Value, 3>> brackets{};
    std::vector<Reach> reached{};
    std::map<std::uint32_t, BitPlace> ahead{};
    bool stopped = false;  // in front of this instruction, where another region begins

    void goTo(std::uint32_t next) {
      jumped = next <= at;
      if (jumped && !behind) behind = at + 1;
      at = next;
    }
  };

  bool canFollow(std::uint32_t at) const {
    return at < listing_.places.size() && listing_.places[at].known &&
           !(at < context_.apart.size() && context_.apart[at]);
  }
  bool mayFollow(const icode::Region& region, Walk& walk) {
    if (!canFollow(walk.at)) return false;
    if (region.instructions == 0 || walk.jumped || !walk.brackets.empty()) return true;
    if (isEntry_[walk.at] == 0) return region.instructions < longest_;
    if (!repeats(region, walk.at)) return false;
    if (!walk.behind) walk.behind = walk.at;
    return true;
  }

  // False: this instruction stays with the interpreter.
  bool lower(icode::Builder& builder, icode::Region& region, Walk& walk) {
    const Operation operation = listing_.places[walk.at].instruction.operation;
    const Lower function = functionOf(operation);
    if (function == nullptr) return false;
    builder.begin(walk.at, model_.time(mc7::info(operation).time));
    Lowering lowering{builder, region.needs,  model_,       listing_,
                      walk.at, walk.brackets, walk.reached, walk.ahead};
    lowering.follows = walk.brackets.empty() && follows(region, walk.at);
    lowering.next = walk.at + 1;
    const bool outermost = isOpening(operation) && walk.brackets.empty();
    if (outermost) walk.ahead.clear();  // of the same brackets, the turn before
    if ((outermost && !prepareBracket(lowering, isEntry_)) || !function(lowering)) {
      builder.cancel();
      return false;
    }
    walk.goTo(lowering.next);
    walk.ended = lowering.ended;
    return true;
  }

  // How many instructions of other blocks this one brings with it.
  std::uint32_t copiedBy(std::uint32_t at) {
    const Shape* const shape = shapes_.of(listing_.places[at]);
    return shape != nullptr ? shape->size : 0;
  }

  bool step(icode::Builder& builder, icode::Region& region, Walk& walk) {
    const Shape* const shape =
        walk.brackets.empty() ? shapes_.of(listing_.places[walk.at]) : nullptr;
    const std::uint32_t size = shape != nullptr ? 1 + shape->size : 0;
    if (shape == nullptr || size > longest_ || size > copied_) return lower(builder, region, walk);
    if (region.instructions + size > longest_) return false;  // it begins a region of its own
    Copying copying(builder, region, walk.reached, {model_, shapes_});
    const Copying::Caller caller{.listing = listing_,
                                 .localBytes = context_.localBytes,
                                 .isOb = context_.isOb,
                                 .parameters = context_.parameters};
    if (!copying.call(*shape, caller, walk.at)) return lower(builder, region, walk);
    copied_ -= size;
    // Behind the ways out of it nobody but a region that begins there comes back quickly.
    walk.stopped =
        shape->branches || listing_.places[walk.at].instruction.operation == Operation::CC;
    walk.goTo(walk.at + 1);
    return true;
  }

  // Returns where the next region may begin.
  std::uint32_t region(std::uint32_t first) {
    icode::Region region;
    region.first = first;
    icode::Builder builder(region);
    knowFromBefore(builder, first);
    Walk walk{.at = first};
    while (!walk.ended && !walk.stopped && mayFollow(region, walk) && step(builder, region, walk)) {
    }
    const std::uint32_t next = walk.behind.value_or(walk.at);
    if (region.instructions == 0 || !walk.brackets.empty()) return std::max(next, first + 1);
    if (!walk.ended) builder.leave(walk.at);
    regions_.push_back(std::move(region));
    return next;
  }

  const mc7::Listing& listing_;
  const CpuModel& model_;
  const Context& context_;
  const std::uint32_t longest_;
  Shapes shapes_;
  std::uint32_t copied_;  // so many instructions of called blocks may still be copied
  std::vector<std::uint8_t> isEntry_, inLoop_;
  std::uint32_t spare_ = kRepeated;
  std::vector<icode::Region> regions_;
};

}  // namespace

Lower functionOf(Operation operation) { return table()[static_cast<std::size_t>(operation)]; }

std::vector<icode::Region> translate(const mc7::Listing& listing, const CpuModel& model,
                                     const Context& context) {
  return Blockwise(listing, model, context).run();
}

}  // namespace merker::translate
