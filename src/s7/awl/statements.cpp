#include "awl/statements.h"

#include <fmt/format.h>

#include <map>

#include "awl/call_text.h"
#include "mc7/disassembly.h"
#include "mc7/listing.h"
#include "mc7/operand_text.h"

namespace merker::awl {
namespace {

using mc7::OperandKind;
using mc7::Operation;

constexpr std::uint32_t kMostLabels = 36 * 36 * 36;

// M000 to MZZZ.
std::string labelName(std::size_t number) {
  static constexpr std::string_view kDigits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ";
  std::string name = "M000";
  for (std::size_t i = 3; i > 0; --i, number /= 36) name[i] = kDigits[number % 36];
  return name;
}

class Writer {
 public:
  Writer(const block::Block& block, const Names& names, const Blocks& blocks, bool calls)
      : block_(block),
        names_(names),
        blocks_(blocks),
        calls_(calls),
        listing_(mc7::list(block.code)) {
    end_ = listing_.places.size();
    if (end_ > 0 && listing_.places.back().known &&
        listing_.places.back().instruction.operation == Operation::BE)
      --end_;
    findLabels();
  }

  std::vector<Statement> write() {
    std::vector<Statement> out;
    for (std::size_t at = 0; at < end_;) {
      Statement statement;
      statement.offset = listing_.places[at].offset;
      if (const auto label = labels_.find(at); label != labels_.end())
        statement.label = label->second;
      const std::size_t begin = at;
      at += take(at, statement);
      statement.editorLines = editorLines(begin, statement.lines.size());
      out.push_back(std::move(statement));
    }
    if (const auto label = labels_.find(end_); label != labels_.end())
      out.push_back({static_cast<std::uint32_t>(block_.code.size()), label->second, {"NOP   0"}});
    return out;
  }

 private:
  void findLabels() {
    for (std::size_t at = 0; at < end_; ++at) {
      const mc7::Place& place = listing_.places[at];
      if (!place.known || isListJump(at)) continue;
      const mc7::Operand& operand = place.instruction.operand;
      if (operand.kind == OperandKind::Jump) {
        const std::int32_t target = listing_.target(place);
        if (target >= 0) labels_.try_emplace(static_cast<std::size_t>(target));
      } else if (operand.kind == OperandKind::JumpList) {
        labels_.try_emplace(at + operand.value + 1);
      }
    }
    std::size_t number = 0;
    for (auto& [place, name] : labels_) name = labelName(++number % kMostLabels);
  }

  // The jump over a parameter list, which belongs to the call before it.
  bool isListJump(std::size_t at) const {
    return at > 0 && at < end_ && takesList(at - 1) &&
           mc7::parameterListLength(std::span(block_.code).subspan(listing_.places[at].offset)) >=
               0;
  }
  bool takesList(std::size_t at) const {
    const mc7::Place& place = listing_.places[at];
    const auto& i = place.instruction;
    const bool named = i.operand.kind == OperandKind::Block ||
                       i.operand.kind == OperandKind::BlockParameter ||
                       i.operand.kind == OperandKind::BlockIndirect;
    return place.known && (i.operation == Operation::UC || i.operation == Operation::CC) && named &&
           (i.operand.blockKind == BlockKind::FC || i.operand.blockKind == BlockKind::SFC);
  }

  // How many instructions the statement takes.
  std::size_t take(std::size_t at, Statement& statement) {
    if (calls_)
      if (const std::size_t taken = call(at, statement)) return taken;
    if (const std::size_t taken = dataAccess(at, statement)) return taken;
    statement.lines.push_back(instruction(at));
    if (takesList(at) && isListJump(at + 1)) {
      list(at, statement);
      return 2;
    }
    return 1;
  }

  std::size_t editorLines(std::size_t at, std::size_t written) {
    if (calls_) return written;
    if (at < behindCall_) return 0;
    Statement whole;
    const std::size_t taken = call(at, whole);
    behindCall_ = at + taken;
    return taken > 0 ? whole.lines.size() : written;
  }

  std::size_t call(std::size_t at, Statement& statement) {
    const std::size_t taken = callLength(listing_, at, end_);
    if (taken == 0) return 0;
    for (std::size_t i = at + 1; i < at + taken; ++i)
      if (labels_.contains(i)) return 0;
    auto lines = callText(listing_, at, taken, names_, blocks_, Mnemonics::German);
    if (lines.empty()) return 0;
    statement.lines = std::move(lines);
    return taken;
  }

  // "AUF DB 5; L DBW 2" is "L DB5.DBW 2".
  std::size_t dataAccess(std::size_t at, Statement& statement) const {
    if (at + 1 >= end_ || labels_.contains(at + 1)) return 0;
    const mc7::Place &open = listing_.places[at], &access = listing_.places[at + 1];
    const mc7::Operand& db = open.instruction.operand;
    const mc7::Operand& operand = access.instruction.operand;
    const bool opens = open.known && open.instruction.operation == Operation::OPEN &&
                       db.kind == OperandKind::Block && db.blockKind == BlockKind::DB &&
                       db.reg == 0;
    if (!opens || !access.known || operand.kind != OperandKind::Memory ||
        operand.area != Area::DataBlock)
      return 0;
    statement.lines.push_back(fmt::format("{:<5} DB{}.{}",
                                          mc7::info(access.instruction.operation).de, db.value,
                                          mc7::operandText(access.instruction, Mnemonics::German)));
    return 2;
  }

  std::string instruction(std::size_t at) const {
    const mc7::Place& place = listing_.places[at];
    if (!place.known) return fmt::format("ILLEGAL // {:04X}", place.offset);
    const mc7::Instruction& i = place.instruction;
    const std::string_view mnemonic = mc7::info(i.operation).de;
    if (i.operand.kind == OperandKind::Jump || i.operand.kind == OperandKind::JumpList) {
      const std::int32_t target = i.operand.kind == OperandKind::JumpList
                                      ? static_cast<std::int32_t>(at + i.operand.value + 1)
                                      : listing_.target(place);
      const auto label = labels_.find(static_cast<std::size_t>(target));
      return fmt::format("{:<5} {}", mnemonic, label == labels_.end() ? "?" : label->second);
    }
    if (const std::string name = names_.of(i.operand); !name.empty())
      return fmt::format("{:<5} {}", mnemonic, name);
    return mc7::text(i, Mnemonics::German);
  }

  // The entries behind a call: no statement of AWL has them. An empty list belongs to UC itself.
  void list(std::size_t at, Statement& statement) const {
    const mc7::Place& jump = listing_.places[at + 1];
    const auto code = std::span(block_.code).subspan(jump.offset);
    const int entries = mc7::parameterListLength(code);
    if (entries > 0) statement.lines.push_back(mc7::text(jump.instruction, Mnemonics::German));
    for (int i = 0; i < entries; ++i)
      statement.lines.push_back(parameterEntry(code.subspan(4 + 4 * static_cast<std::size_t>(i))));
  }

  const block::Block& block_;
  const Names& names_;
  const Blocks& blocks_;
  bool calls_;
  mc7::Listing listing_;
  std::size_t end_ = 0, behindCall_ = 0;
  std::map<std::size_t, std::string> labels_;  // by number of the instruction
};

}  // namespace

std::vector<Statement> statements(const block::Block& block, const Names& names,
                                  const Blocks& blocks, bool calls) {
  return Writer(block, names, blocks, calls).write();
}

}  // namespace merker::awl
