// Load, transfer, code (9.3.3, 9.3.7).
#include "base/bcd.h"
#include "softplc/handlers.h"
#include "softplc/operand_access.h"

namespace merker::sinumerik {
namespace {

using mc5::Area;
using mc5::Instruction;
using mc5::Operand;
using mc5::OperandKind;
using mc5::Operation;

// xxx2 of the fine coding: reading from input modules, writing to output modules (S5-ERR-13).
constexpr std::uint16_t kReading = 0x000E, kWriting = 0x000A;

bool noAnswer(Processor& p, std::uint16_t direction, std::uint32_t byte) {
  const auto number = static_cast<std::uint16_t>(toBcd(byte, 4));
  return p.fail(Alarm::NoAnswerPeriphery, p.opcode(), direction, number);
}

// L PB, L PW: the input modules, past the process image (S5-LOAD-09).
bool loadPeriphery(Processor& p, const Operand& operand) {
  const Periphery& periphery = p.machine().periphery;
  const std::uint32_t bytes = operand.width == mc5::Width::Word ? 2 : 1;
  std::uint32_t value = 0;
  for (std::uint32_t i = 0; i < bytes; ++i) {
    if (!periphery.inputPresent[operand.value + i]) return noAnswer(p, kReading, operand.value + i);
    value = value << 8 | periphery.inputs[operand.value + i];
  }
  p.registers().load(value);
  return true;
}

// T PB, T PW: the output modules and the image, so that the end of the cycle does not undo it
// (OP-30).
bool transferPeriphery(Processor& p, const Operand& operand) {
  Machine& m = p.machine();
  const std::uint32_t bytes = operand.width == mc5::Width::Word ? 2 : 1;
  for (std::uint32_t i = 0; i < bytes; ++i) {
    const std::uint32_t byte = operand.value + i;
    if (!m.periphery.outputPresent[byte]) return noAnswer(p, kWriting, byte);
    const auto value = static_cast<std::uint8_t>(p.registers().akku1 >> (8 * (bytes - 1 - i)));
    m.periphery.outputs[byte] = m.outputs[byte] = value;
  }
  return true;
}

bool load(Processor& p, const Instruction& i) {
  Machine& m = p.machine();
  const Operand& operand = i.operand;
  switch (operand.kind) {
    case OperandKind::Timer:
      p.registers().load(m.timers[operand.value].value());
      return true;
    case OperandKind::Counter:
      p.registers().load(m.counters[operand.value].value());
      return true;
    case OperandKind::Constant:
      p.registers().load(operand.value);
      return true;
    default:
      break;
  }
  if (operand.area == Area::Peripheral) return loadPeriphery(p, operand);
  p.registers().load(read(m, operand));
  return true;
}

bool loadCoded(Processor& p, const Instruction& i) {
  Machine& m = p.machine();
  const std::uint32_t number = i.operand.value;
  p.registers().load(i.operand.kind == OperandKind::Timer ? m.timers[number].coded()
                                                          : m.counters[number].coded());
  return true;
}

bool transfer(Processor& p, const Instruction& i) {
  if (i.operand.area == Area::Peripheral) return transferPeriphery(p, i.operand);
  if (write(p.machine(), i.operand, p.registers().akku1)) return true;
  return p.fail(Alarm::TransferToMissingDb, p.opcode());
}

constexpr HandlerRow kLoadRows[] = {
    {Operation::LOAD, load}, {Operation::LOAD_BCD, loadCoded}, {Operation::TRANSFER, transfer}};

}  // namespace

HandlerRows loadHandlers() { return kLoadRows; }

}  // namespace merker::sinumerik
