#include "icode/builder.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace merker::icode {
namespace {

Opcode loading(unsigned bytes) {
  return bytes == 4 ? Opcode::Load32 : bytes == 2 ? Opcode::Load16 : Opcode::Load8;
}
Opcode storing(unsigned bytes) {
  return bytes == 4 ? Opcode::Store32 : bytes == 2 ? Opcode::Store16 : Opcode::Store8;
}

// Data and instance block can be the same block.
bool mayBeSame(Space a, Space b) {
  return a == b || (a == Space::Data && b == Space::Instance) ||
         (a == Space::Instance && b == Space::Data);
}

// Bytes of these spaces are written when the region is left; nobody looks before.
bool waits(Space space) { return isImage(space) || space == Space::Local; }

}  // namespace

void Builder::begin(std::uint32_t place, std::uint64_t cost) {
  executed_ = region_->instructions++;
  costSoFar_ += cost_;
  aheadBefore_ = std::exchange(region_->ahead, costSoFar_);
  place_ = place;
  cost_ = cost;
}

void Builder::cancel() {
  --region_->instructions;
  region_->ahead = aheadBefore_;
  executed_ = region_->instructions;
  cost_ = 0;
}

namespace {

// By the upper bits, in which all bits of each part show: of REAL constants the lower ones are 0.
std::size_t slotOf(const Op& op) {
  constexpr int kUpper = 64 - std::countr_zero(Builder::kRecent);
  auto hash = static_cast<std::uint64_t>(op.code);
  for (const std::uint32_t part : {op.a, op.b, op.c, op.number})
    hash = (hash ^ part) * 0x9E37'79B9'7F4A'7C15u;
  return static_cast<std::size_t>(hash >> kUpper);
}

}  // namespace

// The same pure operation twice is one value.
Value Builder::append(Op op) {
  if (info(op.code).effect == Effect::Pure) {
    Value& made = made_[slotOf(op)];
    if (made != kNoValue && region_->ops[made] == op) return made;
    made = static_cast<Value>(region_->ops.size());
  }
  region_->ops.push_back(op);
  return static_cast<Value>(region_->ops.size() - 1);
}

Value Builder::constant(std::uint32_t number) {
  return append({.code = Opcode::Constant, .number = number});
}

std::optional<std::uint32_t> Builder::number(Value value) const {
  const Op& op = region_->ops[value];
  if (op.code != Opcode::Constant) return std::nullopt;
  return op.number;
}

Value Builder::get(Item item) {
  Held& held = items_[index(item)];
  if (held.value == kNoValue) held.value = append({.code = Opcode::Get, .item = item});
  return held.value;
}

// A value with the same low half that took less to make.
Value Builder::lowHalf(Value value) const {
  for (;;) {
    const Op& op = region_->ops[value];
    if (op.code == Opcode::LowFrom)
      value = op.b;
    else if (op.code == Opcode::Sext16 || op.code == Opcode::Zext16)
      value = op.a;
    else
      return value;
  }
}

// The high half is 0.
bool Builder::isWord(Value value) const {
  const Op& op = region_->ops[value];
  const bool loaded = op.code == Opcode::Load8 || op.code == Opcode::Load16;
  const bool extended = op.code == Opcode::Zext8 || op.code == Opcode::Zext16;
  return loaded || extended || (op.code == Opcode::Constant && op.number <= 0xFFFF);
}

// All bits above the lowest eight are 0.
bool Builder::isByte(Value value) const {
  constexpr int kFar = 8;
  for (int i = 0; i < kFar && region_->ops[value].code == Opcode::Insert; ++i)
    value = region_->ops[value].a;
  const Op& op = region_->ops[value];
  return op.code == Opcode::Load8 || op.code == Opcode::Zext8 ||
         (op.code == Opcode::Constant && op.number <= 0xFF);
}

// What comes out of numbers that are known.
std::optional<std::uint32_t> Builder::folded(Opcode code, Value a, Value b,
                                             std::uint32_t number) const {
  const auto left = a == kNoValue ? std::nullopt : this->number(a);
  const auto right = b == kNoValue ? std::optional(number) : this->number(b);
  return left && right ? fold(code, *left, *right) : std::nullopt;
}

Value Builder::make(Opcode code, Value a, Value b, std::uint32_t number) {
  if (const auto known = folded(code, a, b, number)) return constant(*known);
  if ((code == Opcode::Add || code == Opcode::Sub) && isNumber(b, 0)) return a;
  if (code == Opcode::Sext16 || code == Opcode::Zext16) a = lowHalf(a);
  if (code == Opcode::Zext16 && isWord(a)) return a;
  if (code == Opcode::Zext8 && isByte(a)) return a;
  if (code == Opcode::LowFrom) b = lowHalf(b);
  if (code == Opcode::LowFrom && isWord(a)) return make(Opcode::Zext16, b);
  if (code == Opcode::LowFrom && region_->ops[a].code == Opcode::LowFrom) a = region_->ops[a].a;
  return append({.code = code, .a = a, .b = b, .number = number});
}
Value Builder::make3(Opcode code, Value a, Value b, Value c) {
  return append({.code = code, .a = a, .b = b, .c = c});
}

Space Builder::held(Space space) const {
  if (!swapped_) return space;
  if (space == Space::Data) return Space::Instance;
  return space == Space::Instance ? Space::Data : space;
}

Value Builder::base(Space space) {
  Value& known = bases_[static_cast<std::size_t>(space)];
  if (known == kNoValue) known = append({.code = Opcode::Base, .space = space});
  return known;
}

Value Builder::limit(Space space, bool write) {
  space = held(space);
  if (space == Space::Local) write = false;  // all of them may be written
  Value& known = limits_[2 * static_cast<std::size_t>(space) + (write ? 1 : 0)];
  if (known == kNoValue)
    known = append({.code = write ? Opcode::WriteLimit : Opcode::Limit, .space = space});
  return known;
}

void Builder::storeNow(const Byte& byte) {
  append({.code = storing(byte.bytes),
          .space = byte.space,
          .a = base(byte.space),
          .b = byte.value,
          .place = byte.place});
}

void Builder::writeBack(Space space, std::uint32_t place, unsigned bytes) {
  for (std::size_t i = 0; i < bytes_.size(); ++i) {
    Byte& byte = bytes_[i];
    if (byte.space != space || !byte.dirty || byte.place >= place + bytes ||
        place >= byte.place + byte.bytes)
      continue;
    byte.dirty = false;
    storeNow(byte);
  }
}

void Builder::forget(Space space, std::uint32_t place, unsigned bytes) {
  std::erase_if(bytes_, [&](const Byte& byte) {
    if (byte.space != space) return mayBeSame(byte.space, space);
    return byte.place < place + bytes && place < byte.place + byte.bytes;
  });
}

Value Builder::load(Space space, std::uint32_t place, unsigned bytes) {
  space = held(space);
  for (const Byte& byte : bytes_)
    if (byte.space == space && byte.place == place && byte.bytes == bytes) return byte.value;
  writeBack(space, place, bytes);
  const Value value =
      append({.code = loading(bytes), .space = space, .a = base(space), .place = place});
  bytes_.push_back({space, place, bytes, value, false});
  return value;
}

// A load gives the byte or word, not what else the register has.
Value Builder::loaded(unsigned bytes, Value value) {
  return bytes == 4 ? value : make(bytes == 2 ? Opcode::Zext16 : Opcode::Zext8, value);
}

void Builder::store(Space space, std::uint32_t place, unsigned bytes, Value value) {
  space = held(space);
  if (bytes == 2) value = lowHalf(value);
  const bool later = bytes == 1 && waits(space);
  const Value now = later ? value : loaded(bytes, value);
  for (const Byte& byte : bytes_)  // it is there already
    if (byte.space == space && byte.place == place && byte.bytes == bytes && byte.value == now)
      return;
  forget(space, place, bytes);
  bytes_.push_back({space, place, bytes, value, later});
  if (!later) storeNow(bytes_.back());
  bytes_.back().value = now;
}

void Builder::writeBackAll(Space space) {
  for (std::size_t i = 0; i < bytes_.size(); ++i)
    if (bytes_[i].dirty && mayBeSame(bytes_[i].space, space)) {
      bytes_[i].dirty = false;
      storeNow(bytes_[i]);
    }
}

void Builder::forgetAll(Space space) {
  std::erase_if(bytes_, [&](const Byte& byte) { return mayBeSame(byte.space, space); });
}

Value Builder::loadAt(Space space, Value offset, std::uint32_t place, unsigned bytes) {
  space = held(space);
  writeBackAll(space);
  const Value address = make(Opcode::Index, base(space), offset);
  return append({.code = loading(bytes), .space = space, .a = address, .place = place});
}

void Builder::storeAt(Space space, Value offset, std::uint32_t place, unsigned bytes, Value value) {
  space = held(space);
  writeBackAll(space);
  forgetAll(space);
  const Value address = make(Opcode::Index, base(space), offset);
  append({.code = storing(bytes), .space = space, .a = address, .b = value, .place = place});
}

Value Builder::locate(Value area, Value bitAddress, Access access) {
  settle();
  return append({.code = Opcode::Locate,
                 .a = area,
                 .b = bitAddress,
                 .number = exit(place_, true),
                 .place = access.packed()});
}

// Such an address can be anywhere.
Value Builder::loadFrom(Value address, unsigned bytes) {
  for (const Space space : {Space::Input, Space::Output, Space::Flag, Space::Local})
    writeBackAll(space);
  return append({.code = loading(bytes), .a = address});
}

void Builder::storeTo(Value address, unsigned bytes, Value value) {
  for (const Space space : {Space::Input, Space::Output, Space::Flag, Space::Local})
    writeBackAll(space);
  bytes_.clear();
  append({.code = storing(bytes), .a = address, .b = value});
}

void Builder::act(Opcode code, Value a, std::uint32_t number, std::uint32_t place) {
  append({.code = code, .a = a, .number = number, .place = place});
}

void Builder::reopen(Space space) {
  const auto i = static_cast<std::size_t>(space);
  reopened_[i] = true;
  bases_[i] = limits_[2 * i] = limits_[2 * i + 1] = kNoValue;
  std::erase_if(bytes_, [space](const Byte& byte) { return byte.space == space; });
}

// While the registers are still to be exchanged, one copy does for that: what this one held is
// gone.
void Builder::open(Space space, Value number, Opening wanted) {
  if (isOpen(space, number, wanted)) return;
  wanted.moves = swapped_;
  append({.code = Opcode::Open,
          .space = space,
          .a = number,
          .number = exit(place_, true),
          .place = wanted.packed()});
  if (std::exchange(swapped_, false)) exchangeKnown();
  reopen(space);
  opened_[static_cast<std::size_t>(space)] = {number, wanted};
}

bool Builder::isOpen(Space space, Value number, const Opening& wanted) const {
  const Opened& opened = opened_[static_cast<std::size_t>(held(space))];
  return opened.number == number && opened.is.bytes >= wanted.bytes &&
         (opened.is.write || !wanted.write);
}

// What is known of the blocks is known of them in their new registers; what the region needs at its
// entry it needs of the old ones.
void Builder::exchangeKnown() {
  const auto data = static_cast<std::size_t>(Space::Data),
             instance = static_cast<std::size_t>(Space::Instance);
  std::swap(bases_[data], bases_[instance]);
  std::swap(opened_[data], opened_[instance]);
  reopened_[data] = reopened_[instance] = true;
  for (const std::size_t write : {0, 1})
    std::swap(limits_[2 * data + write], limits_[2 * instance + write]);
  for (Byte& byte : bytes_)
    if (byte.space == Space::Data || byte.space == Space::Instance)
      byte.space = byte.space == Space::Data ? Space::Instance : Space::Data;
}

void Builder::settle() {
  if (!std::exchange(swapped_, false)) return;
  append({.code = Opcode::SwapBlocks});
  exchangeKnown();
}

// `number` as DataBlockQuery.
Value Builder::blockInfo(std::uint32_t number) {
  return withNumber(Opcode::BlockInfo, kNoValue, swapped_ ? number ^ 1 : number);
}

}  // namespace merker::icode
