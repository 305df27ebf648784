#include "jit/homes.h"

#include <algorithm>

namespace merker::jit {

using icode::Op;
using icode::Opcode;
using icode::Region;
using icode::Value;

namespace {

constexpr std::uint32_t kNone = UINT32_MAX, kSeveral = UINT32_MAX - 1;

bool isStore(const Op& op) { return op.code >= Opcode::Store8 && op.code <= Opcode::Store32; }

std::uint32_t bytesOf(const Op& op) {
  return op.code == Opcode::Store8 ? 1 : op.code == Opcode::Store16 ? 2 : 4;
}

bool changesBit(const Op& op) {
  return op.code == Opcode::Insert || op.code == Opcode::SetWhere || op.code == Opcode::ClearWhere;
}

// At a fixed place of an image.
bool loadsByte(const Region& region, const Op& op) {
  return op.code == Opcode::Load8 && icode::isImage(op.space) &&
         region.ops[op.a].code == Opcode::Base;
}

}  // namespace

Homes::Homes(const Region& region)
    : homes_(region.ops.size(), kNone), writesOf_(region.ops.size(), kNone) {
  if (!noteStores(region)) return;
  noteWrites(region);
  noteExits(region);
  findHomes(region);
}

// False: one of them may write anywhere.
bool Homes::noteStores(const Region& region) {
  for (const Op& op : region.ops) {
    if (!isStore(op)) continue;
    const Opcode address = region.ops[op.a].code;
    const bool direct = address == Opcode::Base;
    if (address == Opcode::Locate || (icode::isImage(op.space) && !direct)) return false;
    if (!icode::isImage(op.space)) continue;
    for (std::uint32_t i = 0; i < bytesOf(op); ++i) stored_.push_back(key(op.space, op.place + i));
  }
  std::sort(stored_.begin(), stored_.end());
  return true;
}

void Homes::noteWrites(const Region& region) {
  for (const icode::ByteWrite& write : region.bytes) {
    std::uint32_t& known = writesOf_[write.value];
    const bool image = icode::isImage(write.space);
    const std::uint32_t at = image ? key(write.space, write.place) : kSeveral;
    if (image && known != at) written_.push_back({.key = at});
    known = known == kNone || known == at ? at : kSeveral;
  }
  const auto byKey = [](const Byte& a, const Byte& b) { return a.key < b.key; };
  const auto same = [](const Byte& a, const Byte& b) { return a.key == b.key; };
  std::sort(written_.begin(), written_.end(), byKey);
  written_.erase(std::unique(written_.begin(), written_.end(), same), written_.end());
}

Homes::Byte* Homes::written(std::uint32_t key) {
  const auto found =
      std::lower_bound(written_.begin(), written_.end(), key,
                       [](const Byte& byte, std::uint32_t k) { return byte.key < k; });
  return found != written_.end() && found->key == key ? &*found : nullptr;
}

void Homes::noteExits(const Region& region) {
  std::vector<std::uint32_t> here;
  for (Value i = 0; i < region.ops.size(); ++i)
    for (const std::uint32_t number : icode::ExitsOf(region, region.ops[i])) {
      const icode::Exit& exit = region.exits[number];
      here.clear();
      for (std::uint32_t k = 0; k < exit.bytes; ++k) {
        const icode::ByteWrite& write = region.bytes[exit.firstByte + k];
        if (icode::isImage(write.space)) here.push_back(key(write.space, write.place));
      }
      std::sort(here.begin(), here.end());
      auto next = here.begin();
      for (Byte& byte : written_) {
        next = std::find_if(next, here.end(), [&](std::uint32_t at) { return at >= byte.key; });
        if (next == here.end() || *next != byte.key) byte.safeFrom = i + 1;
      }
    }
}

// The byte with a bit changed stands there from that operation on (Builder::store).
std::optional<std::uint32_t> Homes::changedByte(const Region& region, Value value) const {
  const Op& op = region.ops[value];
  const std::uint32_t at = writesOf_[value];
  if (!changesBit(op) || at == kNone || at == kSeveral) return std::nullopt;
  const Op& before = region.ops[op.a];
  const bool same = loadsByte(region, before) ? key(before.space, before.place) == at
                                              : changesBit(before) && writesOf_[op.a] == at;
  return same ? std::optional(at) : std::nullopt;
}

void Homes::findHomes(const Region& region) {
  for (Value i = 0; i < region.ops.size(); ++i) {
    const Op& op = region.ops[i];
    std::uint32_t at = kNone;
    if (loadsByte(region, op) && written(key(op.space, op.place)) == nullptr)
      at = key(op.space, op.place);
    if (const auto changed = changedByte(region, i)) at = *changed;
    if (!std::binary_search(stored_.begin(), stored_.end(), at)) homes_[i] = at;
  }
}

std::optional<Homes::Home> Homes::take(Value value, Value now,
                                       const std::function<bool(Value)>& isOver) {
  const std::uint32_t at = homes_[value];
  if (at == kNone) return std::nullopt;
  const Home home{static_cast<icode::Space>(at >> 24), at & 0xFF'FFFF, true};
  Byte* const byte = written(at);
  if (byte == nullptr) return Home{home.space, home.byte, false};
  if (now < byte->safeFrom || (byte->owner != icode::kNoValue && !isOver(byte->owner)))
    return std::nullopt;
  byte->owner = value;
  return home;
}

}  // namespace merker::jit
