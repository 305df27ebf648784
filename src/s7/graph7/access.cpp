#include "graph7/access.h"

#include <fmt/format.h>

#include <initializer_list>

#include "awl/call_parts.h"
#include "mc7/operand_text.h"

namespace merker::graph7 {
namespace {

using mc7::Operation;

class AccessReader {
 public:
  AccessReader(const mc7::Listing& listing, std::size_t at, std::size_t end,
               const awl::Names& names, Mnemonics mnemonics)
      : listing_(listing), at_(at), end_(end), names_(names), mnemonics_(mnemonics) {}

  Access read() const {
    if (Access found = dataBlock(); found.length > 1) return found;
    if (Access found = memberOfParameter(); found.length > 1) return found;
    if (Access found = memberOfInOut(); found.length > 1) return found;
    return numberParameter();
  }

 private:
  const mc7::Instruction& look(std::size_t ahead) const {
    return listing_.places[at_ + ahead].instruction;
  }
  bool follows(std::initializer_list<Operation> operations) const {
    if (at_ + operations.size() >= end_) return false;
    std::size_t i = 0;
    for (const Operation operation : operations) {
      if (!listing_.places[at_ + i].known || look(i).operation != operation) return false;
      ++i;
    }
    return listing_.places[at_ + i].known;
  }
  bool isBld(std::uint32_t number) const { return look(0).operand.value == number; }

  // AUF DB 5; L DBW 2
  Access dataBlock() const {
    if (!follows({Operation::OPEN}) || !awl::opensDb(look(0))) return {};
    const mc7::Operand& operand = look(1).operand;
    if (operand.kind != mc7::OperandKind::Memory || operand.area != Area::DataBlock) return {};
    return {2,
            fmt::format("DB{}.{}", look(0).operand.value, mc7::operandText(look(1), mnemonics_))};
  }

  // An element of a structured parameter of an FC.
  Access memberOfParameter() const {
    using enum Operation;
    if (!follows({BLD, TRANSFER, TAK, TRANSFER, LOAD, LAR1, LOAD, TRANSFER, OPEN, LOAD, LAR1, LOAD,
                  LOAD}) ||
        !isBld(5) || look(4).operand.kind != mc7::OperandKind::ParameterAddress)
      return {};
    const std::uint32_t index = look(4).operand.value;
    const auto parameters = block::parameters(names_.block());
    if (index >= parameters.size()) return member(13, nullptr, names_.parameter(index));
    return member(13, parameters[index], names_.parameter(index));
  }

  // An element of a structured IN_OUT parameter of an FB.
  Access memberOfInOut() const {
    using enum Operation;
    if (!follows({BLD, TRANSFER, TAK, TRANSFER, LOAD, TRANSFER, OPEN, LOAD, LAR1, LOAD, LOAD}) ||
        !isBld(18))
      return {};
    const block::Variable* variable = names_.instance(look(4).operand.value);
    return member(11, variable, variable == nullptr ? std::string() : "#" + variable->name);
  }

  Access member(std::size_t last, const block::Variable* variable, const std::string& name) const {
    const mc7::Operand& operand = look(last).operand;
    if (operand.kind != mc7::OperandKind::RegisterCrossing || operand.reg != 1) return {};
    std::string path;
    if (variable != nullptr)
      path = awl::memberAt(variable->type->members, operand.value, operand.width);
    if (path.empty()) path = mc7::pointerText(Area::None, operand.value, mnemonics_);
    return {last + 1, fmt::format("{}.{}", name, path)};
  }

  // T LD b; TAK; T LD b+4; L DIW [AR2,P#p]; T LW b+8; L LD b+4; L LD b; SE T [LW b+8]
  Access numberParameter() const {
    using enum Operation;
    if (!follows({TRANSFER, TAK, TRANSFER, LOAD, TRANSFER, LOAD, LOAD})) return {};
    const mc7::Operand& operand = look(7).operand;
    if (operand.kind != mc7::OperandKind::TimerIndirect &&
        operand.kind != mc7::OperandKind::CounterIndirect)
      return {};
    const mc7::Operand& number = look(3).operand;
    if (number.kind != mc7::OperandKind::RegisterIndirect || number.reg != 2) return {};
    const block::Variable* variable = names_.instance(number.value);
    return {8, variable == nullptr ? mc7::operandText(look(7), mnemonics_) : "#" + variable->name,
            true};
  }

  const mc7::Listing& listing_;
  std::size_t at_, end_;
  const awl::Names& names_;
  Mnemonics mnemonics_;
};

}  // namespace

Access accessAt(const mc7::Listing& listing, std::size_t at, std::size_t end,
                const awl::Names& names, Mnemonics mnemonics) {
  if (!listing.places[at].known) return {};
  return AccessReader(listing, at, end, names, mnemonics).read();
}

}  // namespace merker::graph7
