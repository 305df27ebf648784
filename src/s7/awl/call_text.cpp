#include "awl/call_text.h"

#include <fmt/format.h>

#include <map>
#include <optional>

#include "awl/call_instance.h"
#include "awl/call_parts.h"
#include "base/bytes.h"
#include "block/width.h"
#include "mc7/operand_text.h"

namespace merker::awl {
namespace {

using mc7::Instruction;
using mc7::OperandKind;
using mc7::Operation;

// BLD numbers that open and close a bracket.
struct Bracket {
  std::uint32_t open, close;
};
constexpr Bracket kBrackets[] = {{1, 2}, {7, 8}, {3, 4}, {9, 10}, {14, 15}, {16, 17}};

std::uint32_t bldNumber(const mc7::Place& place) {
  return place.known && place.instruction.operation == Operation::BLD
             ? place.instruction.operand.value
             : 0;
}

// What is put into a place, or what a place is put into.
struct Actual {
  Instruction instruction;
  std::int32_t db = -1;
  std::int64_t own = -1;  // the address of this place of the own instance
};
// By bit address of the local data.
using Places = std::map<BitAddress, Actual>;

class Call {
 public:
  Call(const mc7::Listing& listing, std::size_t at, std::size_t count, const Names& names,
       const Blocks& blocks, Mnemonics mnemonics)
      : listing_(listing), names_(names), blocks_(blocks), mnemonics_(mnemonics) {
    for (std::size_t i = at + 1; i + 1 < at + count; ++i) body_.push_back(&listing.places[i]);
  }

  std::vector<std::string> text() {
    std::size_t call = 0;
    while (call < body_.size() && body_[call]->instruction.operation != Operation::UC) ++call;
    if (call == body_.size()) return {};
    const mc7::Operand& called = body_[call]->instruction.operand;
    if (called.kind != OperandKind::Block) return {};
    const bool fc = called.blockKind == BlockKind::FC || called.blockKind == BlockKind::SFC;
    const block::Block* callee =
        blocks_({called.blockKind, static_cast<std::uint16_t>(called.value)});
    if (callee == nullptr) return {};
    return fc ? function(call, *callee) : instanceCall(body_, call, *callee, names_, mnemonics_);
  }

 private:
  std::vector<std::string> function(std::size_t call, const block::Block& callee) {
    const auto parameters = block::parameters(callee);
    const mc7::Place& place = *body_[call];
    if (place.parameters != parameters.size()) return {};
    if (!readStaging(call) || !readCopies(call + 2)) return {};
    std::vector<std::string> lines{fmt::format("CALL  {}", toString(callee.id))};
    if (parameters.empty()) return lines;
    lines[0] += " (";
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const std::uint32_t entry = listing_.parameters[place.firstParameter + i];
      const std::string actual = actualOf(*parameters[i], entry);
      if (actual.empty()) return {};
      lines.push_back(fmt::format("{} := {}{}", parameters[i]->name, actual,
                                  i + 1 < parameters.size() ? "," : ")"));
    }
    return lines;
  }

  // `L x; T LW a`, `U x; = L a.b`, `SET; = L a.b`, with an AUF DB before.
  bool readStaging(std::size_t end) {
    std::size_t i = 0;
    if (i < end && stores(body_[i]->instruction) && isLocal(body_[i]->instruction.operand)) ++i;
    if (i < end && body_[i]->instruction.operation == Operation::TAR2) ++i;
    std::int32_t db = -1;
    std::int64_t own = -1;
    const Instruction* source = nullptr;
    for (; i < end; ++i) {
      if (!body_[i]->known) return false;
      const Instruction& now = body_[i]->instruction;
      if (opensDb(now)) {
        db = static_cast<std::int32_t>(now.operand.value);
      } else if (loads(now) || now.operation == Operation::SET || now.operation == Operation::CLR) {
        source = &now;
      } else if (now.operation == Operation::ADD_AR2) {  // +AR2 P#y; TAR2; LAR2 LD b; T LD
        own = now.operand.value;
      } else if (own >= 0 &&
                 (now.operation == Operation::TAR2 || now.operation == Operation::LAR2)) {
        source = &now;
      } else if (stores(now) && isLocal(now.operand) && source != nullptr) {
        staged_[now.operand.value] = {*source, db, own};
        own = -1;
        source = nullptr;
        db = -1;
      } else {
        return false;
      }
    }
    return source == nullptr;
  }

  // `L LW a; T x`, `U L a.b; = x`, with an AUF DB between.
  bool readCopies(std::size_t i) {
    if (i < body_.size() && body_[i]->instruction.operation == Operation::LAR2) ++i;
    std::int32_t db = -1;
    const Instruction* source = nullptr;
    for (; i < body_.size(); ++i) {
      if (!body_[i]->known) return false;
      const Instruction& now = body_[i]->instruction;
      if (loads(now) && isLocal(now.operand)) {
        source = &now;
      } else if (opensDb(now)) {
        db = static_cast<std::int32_t>(now.operand.value);
      } else if (stores(now) && source != nullptr) {
        copied_[source->operand.value] = {now, db, -1};
        source = nullptr;
        db = -1;
      } else {
        return false;
      }
    }
    return source == nullptr;
  }

  std::string actualOf(const block::Variable& parameter, std::uint32_t entry) const {
    const TypeCode type = parameter.type->code;
    if (isParameterNumber(type)) return numberText(type, entry >> 16, mnemonics_);
    const Area area = pointerArea(entry);
    const BitAddress address = pointerAddress(entry);
    const bool elementary = isElementary(type);
    if (area == Area::CallerLocal && !elementary) return complexOf(parameter, address);
    if (!elementary) return {};
    if (area != Area::CallerLocal)
      return operandOf({mc7::Operation::LOAD, mc7::memory(area, block::widthOf(type), address)}, -1,
                       parameter.section != block::Section::Input);
    const auto in = staged_.find(address), out = copied_.find(address);
    if (in != staged_.end()) return valueText(in->second, type);
    if (out != copied_.end()) return operandOf(out->second.instruction, out->second.db, true);
    return operandOf(
        {mc7::Operation::LOAD, mc7::memory(Area::Local, block::widthOf(type), address)}, -1, false);
  }

  std::string valueText(const Actual& actual, TypeCode type) const {
    const Operation operation = actual.instruction.operation;
    if (operation == Operation::SET) return "TRUE";
    if (operation == Operation::CLR) return "FALSE";
    const mc7::Operand& operand = actual.instruction.operand;
    if (operand.kind == OperandKind::Constant) return constantText(type, operand.value);
    return operandOf(actual.instruction, actual.db, false);
  }

  std::string operandOf(Instruction instruction, std::int32_t db, bool written) const {
    if (const std::string name = names_.of(instruction.operand); !name.empty()) return name;
    instruction.operation = written ? Operation::TRANSFER : Operation::LOAD;
    if (instruction.operand.kind != OperandKind::Memory) return {};
    const std::string text = mc7::operandText(instruction, mnemonics_);
    return db < 0 ? text : fmt::format("DB{}.{}", db, text);
  }

  std::optional<std::uint32_t> constantAt(BitAddress address) const {
    const auto at = staged_.find(address);
    if (at == staged_.end() || at->second.instruction.operand.kind != OperandKind::Constant)
      return std::nullopt;
    return at->second.instruction.operand.value;
  }

  // A variable of the own instance whose address is in these bytes.
  std::string ownAt(const block::Variable& parameter, BitAddress address) const {
    const auto at = staged_.find(address);
    if (at == staged_.end() || at->second.own < 0) return {};
    const TypeCode type = parameter.type->code;
    const bool anyType = type == TypeCode::Any || type == TypeCode::Pointer;
    const std::string name =
        partAt(names_.block().variables, static_cast<BitAddress>(at->second.own), *parameter.type,
               anyType);
    return name.empty() ? name : "#" + name;
  }

  // An ANY of ten bytes, a POINTER of six, or a variable of the block that is one.
  std::string complexOf(const block::Variable& parameter, BitAddress address) const {
    const bool any = parameter.type->code == TypeCode::Any;
    if (std::string own = ownAt(parameter, address + (any ? 48 : 16)); !own.empty()) return own;
    if (any) {
      const auto head = constantAt(address), count = constantAt(address + 16);
      const auto db = constantAt(address + 32), pointer = constantAt(address + 48);
      if (head && count && db && pointer) return anyText(*head, *count, *db, *pointer, mnemonics_);
    } else if (const auto db = constantAt(address), pointer = constantAt(address + 16);
               db && pointer) {
      if (parameter.type->code == TypeCode::Pointer) return pointerOf(*db, *pointer, mnemonics_);
      return variableAt(*db, *pointer, *parameter.type);
    }
    if (staged_.contains(address)) return {};
    const block::Variable* variable = names_.local(address);
    return variable == nullptr ? std::string() : "#" + variable->name;
  }

  // A variable of a data block or of the local data that begins there.
  std::string variableAt(std::uint32_t db, std::uint32_t pointer, const block::Type& type) const {
    if (pointerArea(pointer) == Area::CallerLocal) {
      const block::Variable* local = names_.local(pointerAddress(pointer));
      return local == nullptr ? std::string() : "#" + local->name;
    }
    const block::Block* data = blocks_({BlockKind::DB, static_cast<std::uint16_t>(db)});
    if (data == nullptr) return {};
    const std::string name = partAt(data->variables, pointerAddress(pointer), type);
    return name.empty() ? name : fmt::format("DB{}.{}", db, name);
  }

  const mc7::Listing& listing_;
  const Names& names_;
  const Blocks& blocks_;
  Mnemonics mnemonics_;
  std::vector<const mc7::Place*> body_;
  Places staged_, copied_;
};

}  // namespace

std::size_t callLength(const mc7::Listing& listing, std::size_t at, std::size_t end) {
  const std::uint32_t open = bldNumber(listing.places[at]);
  for (const Bracket& bracket : kBrackets) {
    if (bracket.open != open) continue;
    for (std::size_t i = at + 1; i < end; ++i) {
      const std::uint32_t number = bldNumber(listing.places[i]);
      if (number == bracket.close) return i - at + 1;
      if (number == open) return 0;
    }
  }
  return 0;
}

std::vector<std::string> callText(const mc7::Listing& listing, std::size_t at, std::size_t count,
                                  const Names& names, const Blocks& blocks, Mnemonics mnemonics) {
  return Call(listing, at, count, names, blocks, mnemonics).text();
}

std::string parameterEntry(std::span<const std::uint8_t> entry) {
  const std::uint32_t value = loadDWord(entry.data());
  if (pointerArea(value) >= Area::Peripheral && pointerArea(value) <= Area::CallerLocal)
    return mc7::pointerText(pointerArea(value), pointerAddress(value), Mnemonics::German);
  return std::to_string(value >> 16);
}

}  // namespace merker::awl
