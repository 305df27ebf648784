#include "graph7/network_code.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "awl/call_text.h"
#include "base/bytes.h"
#include "graph7/access.h"
#include "graph7/call.h"
#include "graph7/operand_code.h"
#include "graph7/operand_kind.h"
#include "graph7/source_operand.h"
#include "mc7/disassembly.h"
#include "mc7/listing.h"
#include "mc7/operand_text.h"

namespace merker::graph7 {
namespace {

using graph::Op;
using graph::OperandKind;
using graph::Statement;

bool isJump(const mc7::Place& place) {
  return place.known && place.instruction.operand.kind == mc7::OperandKind::Jump;
}

class Lexer {
 public:
  Lexer(const block::Block& block, const awl::Names& names, const awl::Blocks& blocks,
        Mnemonics mnemonics)
      : block_(block),
        names_(names),
        blocks_(blocks),
        mnemonics_(mnemonics),
        listing_(mc7::list(block.code)),
        wires_(behindTemps(names.block())) {
    findNetworks();
    findTargets();
  }

  std::vector<NetworkCode> read() {
    std::vector<NetworkCode> out;
    for (std::size_t i = 0; i + 1 < begins_.size(); ++i) {
      NetworkCode& network = out.emplace_back();
      network.begin = offset(begins_[i]);
      network.end = offset(begins_[i + 1]);
      network.label = nameOf(begins_[i]);
      read(begins_[i], begins_[i + 1], network);
    }
    return out;
  }

 private:
  std::uint32_t offset(std::size_t place) const {
    return place < listing_.places.size() ? listing_.places[place].offset
                                          : static_cast<std::uint32_t>(block_.code.size());
  }

  // begins_: the first instruction of each network, and behind the last network without the BE that
  // ends the block.
  void findNetworks() {
    std::size_t end = listing_.places.size();
    if (end > 0 && listing_.places[end - 1].known &&
        listing_.places[end - 1].instruction.operation == mc7::Operation::BE)
      --end;
    begins_.push_back(0);
    for (const block::Network& network : block_.networks) {
      const std::size_t word = network.offset / 2;
      if (word >= listing_.placeAt.size() || listing_.placeAt[word] < 0) continue;
      const auto place = static_cast<std::size_t>(listing_.placeAt[word]);
      if (place >= begins_.back() && place <= end && &network != &block_.networks.front())
        begins_.push_back(place);
    }
    begins_.push_back(end);
  }

  std::size_t networkOf(std::size_t place) const {
    return static_cast<std::size_t>(std::upper_bound(begins_.begin(), begins_.end() - 1, place) -
                                    begins_.begin());
  }

  // Jumps of other networks, and all but SPBNB of the same one, may only lead to a beginning.
  void reach(std::size_t from, std::size_t to) {
    const std::size_t network = networkOf(to);
    const bool box = listing_.places[from].instruction.operation == mc7::Operation::SPBNB &&
                     networkOf(from) == network;
    if (to < begins_.back() && begins_[network - 1] == to)
      labels_.insert(to);
    else if (!box)
      intruded_.insert(to);
  }

  // Of a jump; -1 for what is none, as the jump over a parameter list.
  std::int32_t targetOf(std::size_t at) const {
    const mc7::Place& place = listing_.places[at];
    return isJump(place) && !isListJump(at) ? listing_.target(place) : -1;
  }
  bool isListJump(std::size_t at) const {
    if (at == 0 || !listing_.places[at - 1].known) return false;
    const mc7::Operation before = listing_.places[at - 1].instruction.operation;
    return (before == mc7::Operation::UC || before == mc7::Operation::CC) &&
           mc7::parameterListLength(std::span(block_.code).subspan(offset(at))) >= 0;
  }

  void findTargets() {
    std::set<std::size_t> targets;
    for (std::size_t at = 0; at < listing_.places.size(); ++at) {
      if (const std::int32_t target = targetOf(at); target >= 0) {
        targets.insert(static_cast<std::size_t>(target));
        reach(at, static_cast<std::size_t>(target));
      }
      const mc7::Place& place = listing_.places[at];
      if (place.known && place.instruction.operand.kind == mc7::OperandKind::JumpList)
        targets.insert(at + place.instruction.operand.value + 1);
    }
    nameTargets(targets);
  }

  // As the source names them. Machine code of another origin has no names.
  void nameTargets(const std::set<std::size_t>& targets) {
    const bool named = block_.labels.size() == targets.size();
    auto name = block_.labels.begin();
    std::size_t number = 0;
    for (const std::size_t place : targets)
      if (named)
        targets_[place] = *name++;
      else if (labels_.contains(place) || intruded_.contains(place))
        targets_[place] = fmt::format("M{:03}", ++number);
  }
  std::string nameOf(std::size_t place) const {
    const auto name = targets_.find(place);
    return name == targets_.end() ? std::string() : name->second;
  }

  void read(std::size_t begin, std::size_t end, NetworkCode& network) {
    graph::Statements& out = network.statements;
    std::map<std::size_t, std::size_t> numbers;  // by place: which statement begins there
    std::vector<std::pair<std::size_t, std::size_t>> jumps;
    for (std::size_t at = begin; at < end;) {
      numbers[at] = out.size();
      Statement& statement = out.emplace_back();
      statement.offset = offset(at);
      network.labels.push_back(at == begin ? std::string() : nameOf(at));
      statement.intruded = intruded_.contains(at);
      const std::size_t taken = take(at, end, statement);
      if (!comesBack(statement, at, at + taken)) statement.op = Op::OTHER;
      if (isJump(listing_.places[at]) && !isListJump(at)) jumps.emplace_back(at, out.size() - 1);
      at += taken;
    }
    std::size_t label = 0;
    for (const auto& [at, number] : jumps) jump(at, numbers, ++label, out[number]);
  }

  // A code that the assembler would write otherwise stays AWL.
  bool comesBack(const Statement& statement, std::size_t from, std::size_t to) const {
    const auto bytes = encode({statement});
    return bytes && *bytes == code(from, to);
  }

  void jump(std::size_t at, const std::map<std::size_t, std::size_t>& numbers, std::size_t number,
            Statement& statement) const {
    const std::int32_t target = listing_.target(listing_.places[at]);
    statement.operand.kind = OperandKind::Forbidden;
    if (target < 0) return;
    const auto place = static_cast<std::size_t>(target);
    if (const std::string name = nameOf(place); !name.empty()) statement.operand.text = name;
    const auto inside = numbers.find(place);
    if (statement.op == Op::SPBNB && inside != numbers.end() && place > at) {
      statement.operand = {};
      statement.operand.kind = OperandKind::Label;
      statement.operand.text = fmt::format("_{:03}", number);
      statement.target = static_cast<std::int32_t>(inside->second);
    } else if (labels_.contains(place)) {
      statement.operand.kind = OperandKind::Label;
    }
  }

  std::size_t take(std::size_t at, std::size_t end, Statement& statement) const {
    if (const std::size_t count = awl::callLength(listing_, at, end)) {
      call(at, count, statement);
      return count;
    }
    if (callsWithoutParameters(at, end)) {
      plainCall(at, statement);
      return 2;
    }
    const Access access = accessAt(listing_, at, end, names_, mnemonics_);
    const std::size_t last = at + access.length - 1;
    const mc7::Place& place = listing_.places[last];
    if (!place.known) return access.length;
    statement.op = operationOf(place.instruction.operation);
    fill(place.instruction, code(at, last), access, statement.operand);
    if (place.parameters > 0) statement.op = Op::OTHER;  // a list that no CALL stands for
    return access.length;
  }

  // UC FC 2 with its empty list.
  bool callsWithoutParameters(std::size_t at, std::size_t end) const {
    return at + 1 < end && isListJump(at + 1) && listing_.places[at].parameters == 0 &&
           listing_.places[at].instruction.operand.kind == mc7::OperandKind::Block;
  }
  void plainCall(std::size_t at, Statement& statement) const {
    const mc7::Instruction& instruction = listing_.places[at].instruction;
    statement.op = operationOf(instruction.operation);
    statement.operand.kind = OperandKind::Number;
    statement.operand.number = instruction.operand.value;
    statement.operand.code = pack({}, instruction.operand);
    statement.operand.text = mc7::operandText(instruction, mnemonics_);
  }

  std::vector<std::uint8_t> code(std::size_t from, std::size_t to) const {
    return {block_.code.begin() + offset(from), block_.code.begin() + offset(to)};
  }

  void call(std::size_t at, std::size_t count, Statement& statement) const {
    statement.op = Op::CALL;
    statement.operand.kind = OperandKind::Number;
    const auto bytes = code(at, at + count);
    statement.operand.code.assign(bytes.begin(), bytes.end());
    describeCall(listing_, at, count, names_, blocks_, mnemonics_, statement);
  }

  void fill(const mc7::Instruction& instruction, const std::vector<std::uint8_t>& before,
            const Access& access, graph::Operand& operand) const {
    const mc7::Operand& machine = instruction.operand;
    operand.kind = kindOf(machine);
    if (access.length > 1) operand.kind = kindOfAccess(access, machine);
    const bool wire = operand.kind == OperandKind::Bit && before.empty() &&
                      machine.kind == mc7::OperandKind::Memory && machine.area == Area::Local &&
                      machine.value >= wires_;
    if (wire) operand.kind = OperandKind::Wire;
    operand.number = machine.value;
    operand.text = !access.text.empty() ? access.text : names_.of(machine);
    if (operand.text.empty()) operand.text = mc7::operandText(instruction, mnemonics_);
    const bool byNumber = wire || operand.kind == OperandKind::Status ||
                          operand.kind == OperandKind::Count || operand.kind == OperandKind::None;
    if (operand.kind == OperandKind::None) operand.number = 0;
    if (!byNumber) operand.code = pack(before, machine);
  }

  static OperandKind kindOfAccess(const Access& access, const mc7::Operand& machine) {
    if (access.timer) return OperandKind::Number;
    return machine.width == Width::Bit ? OperandKind::Bit : OperandKind::Value;
  }

  const block::Block& block_;
  const awl::Names& names_;
  const awl::Blocks& blocks_;
  Mnemonics mnemonics_;
  mc7::Listing listing_;
  BitAddress wires_;
  std::vector<std::size_t> begins_;
  std::map<std::size_t, std::string> targets_;  // of the targets of jumps, by place
  std::set<std::size_t> labels_;                // beginnings of networks that jumps lead to
  std::set<std::size_t> intruded_;              // places that jumps lead to inside networks
};

}  // namespace

std::vector<NetworkCode> networks(const block::Block& block, const awl::Names& names,
                                  const awl::Blocks& blocks, Mnemonics mnemonics) {
  return Lexer(block, names, blocks, mnemonics).read();
}

}  // namespace merker::graph7
