#include "served/values.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/bytes.h"
#include "plc/capability.h"

namespace merker::served {
namespace {

using controller::OperandImage;
using s7comm::ItemCode;
using s7comm::Memory;
using s7comm::Range;
using s7comm::Value;
using s7comm::View;

// The bytes of an area; nothing: there is no such data block.
std::optional<View> areaOf(const OperandImage& image, const Range& range) {
  switch (range.memory) {
    case Memory::Input:
      return image.inputs;
    case Memory::Output:
      return image.outputs;
    case Memory::Flag:
      return image.flags;
    case Memory::Timer:
      return image.timers;
    case Memory::Counter:
      return image.counters;
    case Memory::Peripheral:
      return View();
    case Memory::DataBlock:
      break;
  }
  const auto found =
      std::ranges::lower_bound(image.dataBlocks, range.block, {}, &OperandImage::DataBlock::number);
  if (found == image.dataBlocks.end() || found->number != range.block) return std::nullopt;
  return View(image.data).subspan(found->begin, found->octets);
}

constexpr std::uint8_t isSet(std::uint8_t byte, std::uint8_t bit) {
  return static_cast<std::uint8_t>(byte >> bit & 1);
}

address::Operand byteOperand(const Range& range, std::uint32_t byte) {
  return address::memory(static_cast<Area>(range.memory), Width::Byte, bitAddress(byte));
}

address::Operand operandAt(const Range& range, std::uint32_t offset) {
  if (!s7comm::isCell(range.memory)) {
    address::Operand operand = byteOperand(range, range.begin + offset);
    if (range.oneBit) operand.width = Width::Bit, operand.value += range.bit;
    return operand;
  }
  const std::uint32_t number = range.begin + offset / 2;
  address::Operand cell =
      range.memory == Memory::Timer ? address::timer(number) : address::counter(number);
  cell.width = Width::Word;
  return cell;
}

// What is written is the output side of the periphery.
address::Reference referenceAt(const Range& range, std::uint32_t offset) {
  address::Reference reference;
  reference.operand = operandAt(range, offset);
  if (range.memory == Memory::DataBlock) reference.db = range.block;
  reference.outputSide = range.memory == Memory::Peripheral;
  return reference;
}

ItemCode whyNot(const monitor::Monitor& monitor, const address::Reference& reference) {
  const controller::Controller& plc = monitor.plc();
  if (plc.read(reference)) return ItemCode::AccessDenied;
  address::Reference first = reference;
  first.operand = address::memory(Area::DataBlock, Width::Byte, 0);
  const bool missing = reference.db >= 0 && !plc.read(first);
  return missing ? ItemCode::Missing : ItemCode::OutOfRange;
}

// "E 1.0", as a person reads it where what is forced is listed.
std::string nameOf(const address::Operand& operand) {
  const char area = operand.area == Area::Input ? 'E' : operand.area == Area::Output ? 'A' : 'M';
  return operand.width == Width::Bit
             ? fmt::format("{} {}.{}", area, operand.value / 8, operand.value % 8)
             : fmt::format("{}B {}", area, operand.value / 8);
}

// One byte, bit, timer or counter of a range.
struct Element {
  address::Reference reference;
  monitor::Value value;
  bool terminal = true;  // else the process image
};

std::vector<Element> elementsOf(const s7comm::Write& write) {
  std::vector<Element> elements;
  const std::uint32_t step = s7comm::isCell(write.range.memory) ? 2 : 1;
  for (std::uint32_t i = 0; i + step <= write.octets.size(); i += step) {
    const std::uint8_t* const octet = &write.octets[i];
    const std::uint32_t value = step == 2 ? loadWord(octet) : octet[0];
    elements.push_back({referenceAt(write.range, i), {value, {}}});
  }
  return elements;
}

ItemCode check(const monitor::Monitor& monitor, Element& element) {
  if (!monitor.checkValue(element.reference, element.value)) return ItemCode::Done;
  element.terminal = false;
  const bool image =
      element.reference.operand.area == Area::Input && monitor.plc().read(element.reference);
  return image ? ItemCode::Done : whyNot(monitor, element.reference);
}

}  // namespace

Value valueOf(const OperandImage& image, const Range& range) {
  const auto area = areaOf(image, range);
  if (!area) return {ItemCode::Missing, {}};
  const std::uint64_t begin = std::uint64_t{range.begin} * (s7comm::isCell(range.memory) ? 2 : 1);
  if (begin + range.octets > area->size()) return {ItemCode::OutOfRange, {}};
  const View octets = area->subspan(begin, range.octets);
  if (range.oneBit) return {ItemCode::Done, {isSet(octets[0], range.bit)}};
  return {ItemCode::Done, {octets.begin(), octets.end()}};
}

Value peripheralValue(const controller::Controller& plc, const Range& range) {
  Value value;
  address::Reference reference;
  for (std::uint32_t i = 0; i < range.octets; ++i) {
    reference.operand = byteOperand(range, range.begin + i);
    const auto byte = plc.read(reference);
    if (!byte) return {ItemCode::OutOfRange, {}};
    value.octets.push_back(static_cast<std::uint8_t>(*byte));
  }
  if (range.oneBit) value.octets[0] = isSet(value.octets[0], range.bit);
  return value;
}

ItemCode put(monitor::Monitor& monitor, const s7comm::Write& write) {
  std::vector<Element> elements = elementsOf(write);
  for (Element& element : elements)
    if (const ItemCode code = check(monitor, element); code != ItemCode::Done) return code;
  for (const Element& element : elements) {
    if (!element.terminal)
      monitor.modifyInCycle(element.reference, element.value);
    else if (!monitor::write(monitor.plc(), element.reference, element.value))
      return whyNot(monitor, element.reference);
  }
  return ItemCode::Done;
}

std::vector<Value> valuesNow(const controller::Controller& plc, const std::vector<Range>& ranges) {
  OperandImage image;
  if (const auto* memory = controller::capability<controller::OperandMemory>(plc))
    memory->copyOperands(image);
  std::vector<Value> values;
  values.reserve(ranges.size());
  for (const Range& range : ranges)
    values.push_back(isCopied(range) ? valueOf(image, range) : peripheralValue(plc, range));
  return values;
}

ItemCode putInCycle(monitor::Monitor& monitor, const s7comm::Write& write) {
  std::vector<Element> elements = elementsOf(write);
  for (Element& element : elements)
    if (const ItemCode code = check(monitor, element); code != ItemCode::Done) return code;
  for (const Element& element : elements) monitor.modifyInCycle(element.reference, element.value);
  return ItemCode::Done;
}

bool force(monitor::Monitor& monitor, const std::vector<s7comm::Write>& writes) {
  std::vector<monitor::Change> changes;
  for (const s7comm::Write& write : writes)
    for (Element& element : elementsOf(write)) {
      element.reference.text = nameOf(element.reference.operand);
      changes.push_back({std::move(element.reference), std::move(element.value)});
    }
  return !monitor.force(std::move(changes));
}

}  // namespace merker::served
