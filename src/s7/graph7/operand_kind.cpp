#include "graph7/operand_kind.h"

#include <array>

namespace merker::graph7 {
namespace {

using graph::OperandKind;

constexpr std::size_t kOps = static_cast<std::size_t>(graph::Op::OTHER) + 1;

// Operations of both tables with the same id are the same.
std::array<mc7::Operation, kOps> machineOperations() {
  std::array<mc7::Operation, kOps> out{};
  out.fill(mc7::Operation::NOP1);
  for (std::size_t i = 0; i < mc7::operations().size(); ++i)
    if (const auto op = graph::findOp(mc7::operations()[i].id))
      out[static_cast<std::size_t>(*op)] = static_cast<mc7::Operation>(i);
  return out;
}

OperandKind withWidth(Width width) {
  return width == Width::Bit ? OperandKind::Bit : OperandKind::Value;
}

}  // namespace

OperandKind kindOf(const mc7::Operand& operand) {
  switch (operand.kind) {
    case mc7::OperandKind::None:
      return OperandKind::None;
    case mc7::OperandKind::Memory:
    case mc7::OperandKind::Parameter:
      return withWidth(operand.width);
    case mc7::OperandKind::RegisterIndirect:  // the own data of an FB
      return operand.area == Area::Instance && operand.reg == 2 ? withWidth(operand.width)
                                                                : OperandKind::Forbidden;
    case mc7::OperandKind::Timer:
    case mc7::OperandKind::TimerParameter:
    case mc7::OperandKind::Counter:
    case mc7::OperandKind::CounterParameter:
    case mc7::OperandKind::Block:
    case mc7::OperandKind::BlockParameter:
      return OperandKind::Number;
    case mc7::OperandKind::StatusBit:
      return OperandKind::Status;
    case mc7::OperandKind::Constant:
      return OperandKind::Value;
    case mc7::OperandKind::ShiftCount:
      return OperandKind::Count;
    case mc7::OperandKind::MemoryIndirect:
    case mc7::OperandKind::RegisterCrossing:
    case mc7::OperandKind::TimerIndirect:
    case mc7::OperandKind::CounterIndirect:
    case mc7::OperandKind::StatusWord:
    case mc7::OperandKind::Pointer:
    case mc7::OperandKind::AddressRegister:
    case mc7::OperandKind::Jump:
    case mc7::OperandKind::JumpList:
    case mc7::OperandKind::BlockIndirect:
    case mc7::OperandKind::ParameterAddress:
    case mc7::OperandKind::DataBlockInfo:
      break;
  }
  return OperandKind::Forbidden;
}

graph::Op operationOf(mc7::Operation operation) {
  const auto op = graph::findOp(mc7::info(operation).id);
  return op && *op != graph::Op::CALL ? *op : graph::Op::OTHER;
}

mc7::Operation operationOf(graph::Op op) {
  static const std::array<mc7::Operation, kOps> kOperations = machineOperations();
  return kOperations[static_cast<std::size_t>(op)];
}

}  // namespace merker::graph7
