#include "lowering/translate.h"

#include <array>

#include "lowering/lowering.h"

namespace merker::translate {
namespace {

using icode::Item;
using mc7::Operation;

constexpr std::size_t kOperations = 256;

using Table = std::array<Lower, kOperations>;

Table makeTable() {
  Table table{};
  for (const auto rows : {bitRows(), moveRows(), numberRows(), shiftRows(), realRows(), jumpRows(),
                          callRows(), timerRows(), bcdRows()})
    for (const Row& row : rows) table[static_cast<std::size_t>(row.operation)] = row.lower;
  return table;
}

bool isOpening(Operation o) { return o >= Operation::AND_OPEN && o <= Operation::XOR_NOT_OPEN; }

class Blockwise {
 public:
  Blockwise(const mc7::Listing& listing, const CpuModel& model, const std::vector<bool>& apart,
            std::uint32_t longest)
      : listing_(listing),
        model_(model),
        apart_(apart),
        longest_(longest),
        isEntry_(listing.places.size() + 1) {}

  std::vector<icode::Region> run() {
    markEntries();
    const auto count = static_cast<std::uint32_t>(listing_.places.size());
    for (std::uint32_t at = 0; at < count;) at = region(at);
    return std::move(regions_);
  }

 private:
  // A jump to the next instruction, as over a list of parameters, makes no entry.
  void markEntries() {
    for (std::uint32_t at = 0; at < listing_.places.size(); ++at) {
      const mc7::Place& place = listing_.places[at];
      if (!place.known || place.instruction.operand.kind != mc7::OperandKind::Jump) continue;
      const auto to = static_cast<std::uint32_t>(listing_.target(place));
      if (to < isEntry_.size() && to != at + 1) isEntry_[to] = 1;
    }
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

  bool mayFollow(const icode::Region& region, std::uint32_t at, bool inBrackets) const {
    if (at >= listing_.places.size() || !listing_.places[at].known) return false;
    if (at < apart_.size() && apart_[at]) return false;
    if (region.instructions == 0 || inBrackets) return true;
    return isEntry_[at] == 0 && region.instructions < longest_;
  }

  // Returns where the next region may begin.
  std::uint32_t region(std::uint32_t first) {
    icode::Region region;
    region.first = first;
    icode::Builder builder(region);
    knowFromBefore(builder, first);
    std::vector<std::array<icode::Value, 3>> brackets;
    std::vector<Reach> reached;
    std::map<std::uint32_t, BitPlace> ahead;
    std::uint32_t at = first;
    bool ended = false;
    while (!ended && mayFollow(region, at, !brackets.empty())) {
      const mc7::Place& place = listing_.places[at];
      const Operation operation = place.instruction.operation;
      const Lower lower = table()[static_cast<std::size_t>(operation)];
      if (lower == nullptr) break;
      builder.begin(at, model_.time(mc7::info(operation).time));
      Lowering lowering{builder, region.needs, model_, listing_, at, brackets, reached, ahead};
      const bool outermost = isOpening(operation) && brackets.empty();
      if ((outermost && !prepareBracket(lowering, isEntry_)) || !lower(lowering)) {
        builder.cancel();
        break;
      }
      ended = lowering.ended;
      ++at;
    }
    if (region.instructions == 0 || !brackets.empty()) return std::max(at, first + 1);
    if (!ended) builder.leave(at);
    regions_.push_back(std::move(region));
    return at;
  }

  static const Table& table() {
    static const Table rows = makeTable();
    return rows;
  }

  const mc7::Listing& listing_;
  const CpuModel& model_;
  const std::vector<bool>& apart_;
  const std::uint32_t longest_;
  std::vector<std::uint8_t> isEntry_;
  std::vector<icode::Region> regions_;
};

}  // namespace

std::vector<icode::Region> translate(const mc7::Listing& listing, const CpuModel& model,
                                     const std::vector<bool>& apart, std::uint32_t longest) {
  return Blockwise(listing, model, apart, longest).run();
}

}  // namespace merker::translate
