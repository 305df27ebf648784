#include "station/values.h"

#include "base/bcd.h"
#include "cpu/memory_access.h"
#include "plc/cell_value.h"

namespace merker::station {
namespace {

using address::Operand;
using address::OperandKind;
using cpu::Machine;

// A place among bytes; null if the operand does not lie in them.
struct Bytes {
  std::uint8_t* data = nullptr;
  std::uint32_t length = 0;
};

std::uint8_t* place(Bytes bytes, const Operand& operand) {
  const std::uint32_t end = operand.value / 8 + byteCount(operand.width);
  const bool aligned = operand.width == Width::Bit || operand.value % 8 == 0;
  return aligned && end <= bytes.length ? bytes.data + operand.value / 8 : nullptr;
}

Bytes all(std::vector<std::uint8_t>& bytes) {
  return {bytes.data(), static_cast<std::uint32_t>(bytes.size())};
}

Bytes imageOf(Machine& m, Area area) {
  return {m.image + m.areas.base(area), m.areas.length(area)};
}

// PE: the input terminals. PA: what the output side holds. Both only where something answers
// (S7-OPND-11).
Bytes periphery(Machine& m, const address::Reference& reference) {
  const Operand& operand = reference.operand;
  cpu::Areas& areas = m.areas;
  const auto& present = reference.outputSide ? areas.outputPresent : areas.inputPresent;
  if (!areas.answers(present, operand.value / 8, byteCount(operand.width))) return {};
  return all(reference.outputSide ? areas.outputs : areas.inputs);
}

Bytes localOf(const cpu::Frame* frame) {
  return frame == nullptr ? Bytes{} : Bytes{frame->local, frame->localLength};
}

// L: of the block that runs, or stands in HALT; V: of the one that called it.
Bytes bytesOf(Machine& m, const address::Reference& reference, bool write) {
  switch (reference.operand.area) {
    case Area::Input:
      return write ? all(m.areas.inputs) : imageOf(m, Area::Input);
    case Area::Output:
    case Area::Flag:
      return imageOf(m, reference.operand.area);
    case Area::Peripheral:
      return periphery(m, reference);
    case Area::DataBlock: {
      cpu::DataBlock* block =
          reference.db < 0 ? nullptr : m.dataBlocks.find(static_cast<std::uint32_t>(reference.db));
      return block == nullptr ? Bytes{} : all(block->data);
    }
    case Area::Local:
      return localOf(m.top);
    case Area::CallerLocal:
      return localOf(m.caller());
    default:
      return {};
  }
}

std::uint32_t get(const std::uint8_t* bytes, const Operand& operand) {
  if (operand.width == Width::Bit) return *bytes >> (operand.value & 7) & 1;
  return cpu::loadBytes(bytes, operand.width);
}

void put(std::uint8_t* bytes, const Operand& operand, std::uint32_t value) {
  if (operand.width != Width::Bit) return cpu::storeBytes(bytes, operand.width, value);
  const auto mask = static_cast<std::uint8_t>(1u << (operand.value & 7));
  *bytes = static_cast<std::uint8_t>(value != 0 ? *bytes | mask : *bytes & ~mask);
}

// What the modules put out: with output disable their substitute values.
std::optional<std::uint32_t> readOutputs(const io::Rack& rack, const Operand& operand) {
  std::uint8_t bytes[4] = {};
  for (std::uint32_t i = 0; i < byteCount(operand.width); ++i) {
    const std::uint32_t byte = operand.value / 8 + i;
    if (!rack.answersOutput(byte)) return std::nullopt;
    bytes[i] = rack.putOut(byte);
  }
  return get(bytes, operand);
}

bool deliver(cpu::Cpu& cpu, Periphery& periphery, const Operand& operand, std::uint32_t value) {
  std::uint8_t bytes[4] = {};
  const bool bit = operand.width == Width::Bit;
  const auto mask = static_cast<std::uint8_t>(bit ? 1u << (operand.value & 7) : 0xFFu);
  put(bytes, operand, value);
  return periphery.deliver(cpu, operand.value / 8, byteCount(operand.width), mask, bytes);
}

// What goes to the output side lies in the output image as well (S7-OPND-10), and goes to a module.
void outputFollows(cpu::Cpu& cpu, const Operand& operand) {
  cpu::Areas& areas = cpu.machine().areas;
  const std::uint32_t first = operand.value / 8, count = byteCount(operand.width);
  for (std::uint32_t i = first; i < first + count && i < areas.imageBytes; ++i)
    *areas.output(i) = areas.outputs[i];
  cpu.modules().written(first, count);
}

// A forced output leaves at once.
void forceNow(cpu::Cpu& cpu, std::uint32_t imageByte, std::uint8_t mask, std::uint8_t value) {
  cpu::Areas& areas = cpu.machine().areas;
  const auto merge = [&](std::uint8_t& byte) {
    byte = static_cast<std::uint8_t>((byte & ~mask) | (value & mask));
  };
  merge(areas.image[imageByte]);
  if (imageByte < areas.outputBase || imageByte >= areas.flagBase) return;
  const std::uint32_t byte = imageByte - areas.outputBase;
  merge(areas.outputs[byte]);
  cpu.modules().written(byte, 1);
}

}  // namespace

// T and Z as bits show their status, else what LC loads (S5TIME, BCD).
std::optional<std::uint32_t> readValue(cpu::Cpu& cpu, const Periphery* periphery,
                                       const address::Reference& reference) {
  Machine& m = cpu.machine();
  const Operand& operand = reference.operand;
  const bool bit = operand.width == Width::Bit;
  if (operand.kind == OperandKind::Timer) {
    if (operand.value >= m.timers.size()) return std::nullopt;
    const cpu::S5Timer& timer = m.timers[operand.value];
    return bit ? timer.status(cpu.state().programTime()) : timer.s5time(cpu.state().programTime());
  }
  if (operand.kind == OperandKind::Counter) {
    if (operand.value >= m.counters.size()) return std::nullopt;
    const cpu::S5Counter& counter = m.counters[operand.value];
    return bit ? counter.count > 0 : counter.bcd();
  }
  if (operand.kind != OperandKind::Memory) return std::nullopt;
  if (reference.outputSide && periphery != nullptr) return readOutputs(periphery->rack(), operand);
  const std::uint8_t* bytes = place(bytesOf(m, reference, false), operand);
  if (bytes == nullptr) return std::nullopt;
  if (reference.outputSide && cpu.modules().outputsDisabled()) return 0;  // S7-STATE-02
  return get(bytes, operand);
}

bool writeValue(cpu::Cpu& cpu, Periphery* periphery, const address::Reference& reference,
                std::uint32_t value) {
  Machine& m = cpu.machine();
  const Operand& operand = reference.operand;
  if (operand.kind == OperandKind::Timer)
    return operand.value < m.timers.size() && operand.width != Width::Bit &&
           controller::isCellValue(operand.kind, value) &&
           m.timers[operand.value].modify(static_cast<std::uint16_t>(value),
                                          cpu.state().programTime());
  if (operand.kind == OperandKind::Counter) {
    if (operand.value >= m.counters.size() || !controller::isCellValue(operand.kind, value))
      return false;
    m.counters[operand.value].count = static_cast<std::uint16_t>(*fromBcd(value, 3));
    return true;
  }
  if (operand.kind != OperandKind::Memory) return false;
  const bool terminal = operand.area == Area::Input || operand.area == Area::Peripheral;
  if (periphery != nullptr && terminal && !reference.outputSide)
    return deliver(cpu, *periphery, operand, value);
  std::uint8_t* bytes = place(bytesOf(m, reference, true), operand);
  if (bytes == nullptr) return false;
  put(bytes, operand, value);
  if (reference.outputSide) outputFollows(cpu, operand);
  return true;
}

std::span<std::uint8_t> bytesAt(cpu::Cpu& cpu, const address::Reference& reference) {
  const Operand& operand = reference.operand;
  if (operand.kind != OperandKind::Memory) return {};
  const Bytes area = bytesOf(cpu.machine(), reference, true);
  const std::uint32_t first = operand.value / 8;
  if (first > area.length || reference.bytes > area.length - first) return {};
  return {area.data + first, reference.bytes};
}

bool forceValue(cpu::Cpu& cpu, const address::Reference& reference, std::uint32_t value) {
  Machine& m = cpu.machine();
  const Operand& operand = reference.operand;
  const bool image = operand.area == Area::Input || operand.area == Area::Output;
  if (operand.kind != OperandKind::Memory || !image) return false;
  std::uint8_t* bytes = place(imageOf(m, operand.area), operand);
  if (bytes == nullptr || m.areas.length(operand.area) == 0) return false;
  std::uint8_t values[4] = {};
  const bool bit = operand.width == Width::Bit;
  const auto mask = static_cast<std::uint8_t>(bit ? 1u << (operand.value & 7) : 0xFFu);
  if (bit)
    values[0] = value != 0 ? mask : std::uint8_t{0};
  else
    cpu::storeBytes(values, operand.width, value);
  const auto first = static_cast<std::uint32_t>(bytes - m.image);
  for (std::uint32_t i = 0; i < byteCount(operand.width); ++i) {
    cpu.forces().set(first + i, mask, values[i]);
    forceNow(cpu, first + i, mask, values[i]);
  }
  return true;
}

}  // namespace merker::station
