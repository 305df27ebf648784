#include "awl/call_instance.h"

#include <fmt/format.h>

#include <map>
#include <optional>

#include "mc7/operand_text.h"

namespace merker::awl {
namespace {

using mc7::Instruction;
using mc7::OperandKind;
using mc7::Operation;

// The other side of a transfer: an operand, of a data block that was opened as DI for it.
struct Side {
  Instruction instruction;
  std::int32_t db = -1;
};

class InstanceCall {
 public:
  InstanceCall(const Body& body, std::size_t call, const block::Block& callee, const Names& names,
               Mnemonics mnemonics)
      : body_(body), call_(call), callee_(callee), names_(names), mnemonics_(mnemonics) {}

  std::vector<std::string> text() {
    std::size_t at = 0;
    if (!head(at) || !transfers(at, call_, before_, false)) return {};
    at = call_ + 1;
    if (at < body_.size() && is(at, Operation::LAR2)) ++at;
    if (body_.empty() || !is(body_.size() - 1, Operation::SWAP_DB)) return {};
    if (!transfers(at, body_.size() - 1, behind_, true)) return {};
    return lines();
  }

 private:
  const Instruction& instruction(std::size_t at) const { return body_[at]->instruction; }
  bool is(std::size_t at, Operation operation) const {
    return at < body_.size() && body_[at]->known && instruction(at).operation == operation;
  }

  // Up to TAR2: which instance it is.
  bool head(std::size_t& at) {
    if (is(at, Operation::ASSIGN) && isLocal(instruction(at).operand)) ++at;
    const bool multiple =
        is(at, Operation::LOAD) && instruction(at).operand.kind == OperandKind::DataBlockInfo;
    if (multiple) at += 2;  // L DINO; T LW
    if (!is(at, Operation::SWAP_DB) || !is(at + 1, Operation::OPEN)) return false;
    const Instruction& open = instruction(at + 1);
    if (!multiple && !opensBlock(open, 1)) return false;
    db_ = multiple ? -1 : static_cast<std::int32_t>(open.operand.value);
    at += 2;
    if (is(at, Operation::TAR2)) ++at;
    if (call_ == 0) return false;
    const Instruction& last = instruction(call_ - 1);  // LAR2 P#DBX 0.0, +AR2 P#2.0
    if (multiple ? last.operation != Operation::ADD_AR2 : last.operation != Operation::LAR2)
      return false;
    offset_ = multiple ? last.operand.value : 0;
    return true;
  }

  // The place in the instance of the callee; nothing if it is another operand.
  std::optional<BitAddress> placeOf(const mc7::Operand& operand) const {
    if (operand.area != Area::Instance) return std::nullopt;
    if (db_ >= 0 && operand.kind == OperandKind::Memory) return operand.value;
    if (db_ < 0 && operand.kind == OperandKind::RegisterIndirect && operand.reg == 2 &&
        operand.value >= offset_)
      return operand.value - offset_;
    return std::nullopt;
  }

  using Sides = std::map<BitAddress, Side>;
  // `L x; T DIW y` before the call, `L DIW y; T x` behind it.
  bool transfers(std::size_t at, std::size_t end, Sides& sides, bool behind) {
    if (!behind) --end;  // the LAR2 or +AR2 before UC
    const Instruction* source = nullptr;
    std::int32_t db = -1;
    for (; at < end; ++at) {
      if (!body_[at]->known) return false;
      const Instruction& now = instruction(at);
      if (now.operation == Operation::OPEN) {
        const bool own = !opensBlock(now, 1) || static_cast<std::int32_t>(now.operand.value) == db_;
        const bool before = behind ? source != nullptr : source == nullptr;
        if (!own && before) db = static_cast<std::int32_t>(now.operand.value);
      } else if (loads(now) || now.operation == Operation::SET || now.operation == Operation::CLR) {
        if (source != nullptr) return false;
        source = &now;
      } else if (stores(now) && source != nullptr) {
        const auto place = placeOf(behind ? source->operand : now.operand);
        if (!place) return false;
        sides[*place] = {behind ? now : *source, db};
        source = nullptr;
        db = -1;
      } else {
        return false;
      }
    }
    return source == nullptr;
  }

  std::vector<std::string> lines() {
    std::string first = fmt::format("CALL  {}, DB {}", toString(callee_.id), db_);
    if (db_ < 0) {
      const block::Variable* instance = names_.instance(offset_);
      if (instance == nullptr) return {};
      first = "CALL  #" + instance->name;
    }
    std::vector<std::string> parameters;
    std::size_t used = 0;
    for (const block::Variable& v : callee_.variables) {
      if (v.section > block::Section::InOut) continue;
      const std::size_t before = used;
      const std::string actual = actualOf(v, used);
      if (used > before && actual.empty()) return {};
      if (!actual.empty()) parameters.push_back(fmt::format("{} := {}", v.name, actual));
    }
    if (used != before_.size()) return {};
    return withParameters(first, parameters);
  }

  static std::vector<std::string> withParameters(const std::string& first,
                                                 const std::vector<std::string>& parameters) {
    std::vector<std::string> lines{first + (parameters.empty() ? "" : " (")};
    for (std::size_t i = 0; i < parameters.size(); ++i)
      lines.push_back(parameters[i] + (i + 1 < parameters.size() ? "," : ")"));
    return lines;
  }

  std::string actualOf(const block::Variable& v, std::size_t& used) const {
    const TypeCode type = v.type->code;
    if (type == TypeCode::Any && v.section != block::Section::InOut) return any(v.address, used);
    const auto in = before_.find(v.address), out = behind_.find(v.address);
    if (in != before_.end()) {
      ++used;
      return textOf(in->second, type, false);
    }
    return out == behind_.end() ? std::string() : textOf(out->second, type, true);
  }

  std::string any(BitAddress at, std::size_t& used) const {
    std::uint32_t parts[4] = {};
    constexpr BitAddress kPlaces[] = {0, 16, 32, 48};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto found = before_.find(at + kPlaces[i]);
      if (found == before_.end()) return {};
      ++used;
      if (found->second.instruction.operand.kind != OperandKind::Constant) return {};
      parts[i] = found->second.instruction.operand.value;
    }
    return anyText(parts[0], parts[1], parts[2], parts[3], mnemonics_);
  }

  std::string textOf(const Side& side, TypeCode type, bool written) const {
    Instruction i = side.instruction;
    if (i.operation == Operation::SET) return "TRUE";
    if (i.operation == Operation::CLR) return "FALSE";
    if (i.operand.kind == OperandKind::Constant)
      return isParameterNumber(type) ? numberText(type, i.operand.value, mnemonics_)
                                     : constantText(type, i.operand.value);
    // The caller's own data are reached through DB within the sequence.
    if (i.operand.kind == OperandKind::RegisterIndirect && i.operand.area == Area::DataBlock)
      i.operand.area = Area::Instance;
    if (const std::string name = names_.of(i.operand); !name.empty()) return name;
    if (i.operand.kind != OperandKind::Memory) return {};
    i.operation = written ? Operation::TRANSFER : Operation::LOAD;
    if (i.operand.area == Area::Instance) {
      if (side.db < 0) return {};
      i.operand.area = Area::DataBlock;
      return fmt::format("DB{}.{}", side.db, mc7::operandText(i, mnemonics_));
    }
    return side.db < 0 ? mc7::operandText(i, mnemonics_) : std::string();
  }

  const Body& body_;
  std::size_t call_;
  const block::Block& callee_;
  const Names& names_;
  Mnemonics mnemonics_;
  std::int32_t db_ = -1;
  BitAddress offset_ = 0;
  Sides before_, behind_;
};

}  // namespace

std::vector<std::string> instanceCall(const Body& body, std::size_t call,
                                      const block::Block& callee, const Names& names,
                                      Mnemonics mnemonics) {
  return InstanceCall(body, call, callee, names, mnemonics).text();
}

}  // namespace merker::awl
