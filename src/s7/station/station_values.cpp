// Values of a station, or of the other one at its line, as seen from outside.
#include <fmt/format.h>

#include <algorithm>

#include "base/bytes.h"
#include "station/parts.h"
#include "station/values.h"

namespace merker::station {

void Station::couple(std::unique_ptr<Station> partner) {
  Parts *own = parts_.get(), *other = partner->parts_.get();
  if (own->serial() == nullptr || other->serial() == nullptr) return;
  own->partner = std::move(partner);
  own->serial()->join(
      *other->serial(), [other](Instant t) { other->follow(t); },
      [own](Instant t) { own->follow(t); });
  own->partner->memoryReset();
  own->partner->start();
}

controller::Controller* Station::partner() {
  parts_->takeAlong();
  return parts_->partner.get();
}

namespace {

// The reference as the partner itself would have it.
address::Reference own(address::Reference reference) {
  reference.partner = false;
  return reference;
}

}  // namespace

std::optional<std::uint32_t> Station::read(const address::Reference& reference) const {
  if (reference.partner)
    return parts_->partner ? parts_->partner->read(own(reference)) : std::nullopt;
  return readValue(parts_->cpu, parts_->periphery.get(), reference);
}
bool Station::write(const address::Reference& reference, std::uint32_t value) {
  if (reference.partner) return parts_->partner && parts_->partner->write(own(reference), value);
  parts_->cpu.quiet().forget();
  return writeValue(parts_->cpu, parts_->periphery.get(), reference, value);
}
bool Station::force(const address::Reference& reference, std::uint32_t value) {
  if (reference.partner) return parts_->partner && parts_->partner->force(own(reference), value);
  parts_->cpu.quiet().forget();
  return forceValue(parts_->cpu, reference, value);
}
void Station::unforce() {
  parts_->cpu.quiet().forget();
  parts_->cpu.forces().release();
  if (parts_->partner) parts_->partner->unforce();
}

std::optional<std::vector<std::uint8_t>> Station::readBytes(
    const address::Reference& reference) const {
  if (reference.partner)
    return parts_->partner ? parts_->partner->readBytes(own(reference)) : std::nullopt;
  const auto bytes = bytesAt(parts_->cpu, reference);
  if (bytes.empty()) return std::nullopt;
  return std::vector<std::uint8_t>(bytes.begin(), bytes.end());
}
bool Station::writeBytes(const address::Reference& reference, std::span<const std::uint8_t> bytes) {
  if (reference.partner)
    return parts_->partner && parts_->partner->writeBytes(own(reference), bytes);
  const auto place = bytesAt(parts_->cpu, reference);
  if (place.empty() || place.size() != bytes.size()) return false;
  parts_->cpu.quiet().forget();
  std::copy(bytes.begin(), bytes.end(), place.begin());
  return true;
}

namespace {

template <typename Cells, typename Word>
void copyCells(const Cells& cells, std::vector<std::uint8_t>& bytes, Word word) {
  bytes.resize(2 * cells.size());
  std::uint8_t* at = bytes.data();
  for (const auto& cell : cells) {
    storeWord(at, word(cell));
    at += 2;
  }
}

void copyDataBlocks(const cpu::DataBlocks& blocks, controller::OperandImage& image) {
  image.data.clear();
  image.dataBlocks.clear();
  for (std::size_t number = 1; number < blocks.all().size(); ++number) {
    const cpu::DataBlock& block = blocks.all()[number];
    if (!block.loaded) continue;
    image.dataBlocks.push_back({static_cast<std::uint16_t>(number),
                                static_cast<std::uint32_t>(image.data.size()),
                                static_cast<std::uint32_t>(block.data.size())});
    image.data.insert(image.data.end(), block.data.begin(), block.data.end());
  }
}

}  // namespace

void Station::copyOperands(controller::OperandImage& image) const {
  const cpu::Machine& m = parts_->cpu.machine();
  const auto area = [&](Area which, std::vector<std::uint8_t>& bytes) {
    const std::uint8_t* const begin = m.image + m.areas.base(which);
    bytes.assign(begin, begin + m.areas.length(which));
  };
  area(Area::Input, image.inputs);
  area(Area::Output, image.outputs);
  area(Area::Flag, image.flags);
  const Instant now = parts_->cpu.state().programTime();
  copyCells(m.timers, image.timers, [&](const cpu::S5Timer& timer) { return timer.s5time(now); });
  copyCells(m.counters, image.counters, [](const cpu::S5Counter& one) { return one.bcd(); });
  copyDataBlocks(m.dataBlocks, image);
}

std::string Station::whyMissing(const address::Reference& reference) const {
  if (reference.partner && parts_->partner) return parts_->partner->whyMissing(own(reference));
  const bool data = reference.operand.kind == address::OperandKind::Memory &&
                    reference.operand.area == Area::DataBlock;
  if (!data) return "no module answers at this address";
  const auto found = program().find({BlockKind::DB, static_cast<std::uint16_t>(reference.db)});
  if (found == program().end()) return fmt::format("there is no DB {}", reference.db);
  return fmt::format("DB {} has {} bytes", reference.db, found->second.actualData.size());
}

bool Station::isReadOnly(const address::Reference& reference) const {
  if (reference.db < 0) return false;
  const Station& owner = reference.partner && parts_->partner ? *parts_->partner : *this;
  const auto number = static_cast<std::uint32_t>(reference.db);
  const cpu::DataBlock* const block = owner.cpu().machine().dataBlocks.find(number);
  return block != nullptr && block->readOnly;
}

std::string Station::whyRefused(const address::Reference& reference) const {
  if (reference.partner && parts_->partner) return parts_->partner->whyRefused(own(reference));
  const address::Operand& operand = reference.operand;
  if (address::isCounter(operand)) return "it takes 0 to 999";
  if (isReadOnly(reference)) return fmt::format("DB {} is READ_ONLY", reference.db);
  if (!address::isTimer(operand)) return whyMissing(reference);
  return operand.width == Width::Bit ? "only the program starts a timer"
                                     : "it takes S5T#0MS to S5T#2H46M30S";
}

}  // namespace merker::station
