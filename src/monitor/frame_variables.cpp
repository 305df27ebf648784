#include "monitor/frame_variables.h"

#include <fmt/format.h>

#include "address/constant.h"
#include "cpu/memory_access.h"
#include "monitor/stacks.h"

namespace merker::monitor {
namespace {

constexpr std::size_t kMostRows = 256;

struct Bytes {
  const std::uint8_t* data = nullptr;
  std::size_t length = 0;
};

// Where a variable lies: bytes and the bit address in them.
struct Home {
  Bytes bytes;
  BitAddress address = 0;
};

std::optional<std::uint32_t> read(const Home& home, unsigned bits) {
  const std::size_t byte = home.address / 8;
  if (home.bytes.data == nullptr || bits == 0 || bits > 32) return std::nullopt;
  if (byte + (bits + 7) / 8 > home.bytes.length) return std::nullopt;
  if (bits == 1) return home.bytes.data[byte] >> (home.address & 7) & 1;
  const Width width = bits == 32 ? Width::DWord : bits == 16 ? Width::Word : Width::Byte;
  return cpu::loadBytes(home.bytes.data + byte, width);
}

Bytes of(const cpu::OpenBlock& open) { return {open.data, open.length}; }
Bytes localOf(const cpu::Frame& frame) { return {frame.local, frame.localLength}; }

std::string sectionName(block::Section section) {
  constexpr std::string_view kNames[] = {"", "IN", "OUT", "IN_OUT", "STAT", "TEMP", "RETURN"};
  return std::string(kNames[static_cast<std::size_t>(section)]);
}

class Reader {
 public:
  Reader(const cpu::Machine& m, std::size_t frame)
      : m_(m), index_(frame), frame_(m.frames[frame]), open_(openBlocks(m, frame)) {}

  std::vector<FrameVariable> all() {
    const block::Block& block = *frame_.code->source;
    const bool function = block.id.kind == BlockKind::FC;
    const std::vector<const block::Variable*> list = block::parameters(block);
    for (std::size_t i = 0; function && i < list.size(); ++i) add(*list[i], parameter(i));
    for (const block::Variable& variable : block.variables) {
      if (variable.section == block::Section::Temp)
        add(variable, {localOf(frame_), variable.address});
      else if (!function)
        add(variable, {of(open_.di), pointerAddress(open_.ar2) + variable.address});
    }
    return std::move(rows_);
  }

 private:
  // The pointer behind the call (S7-PAR-01).
  Home parameter(std::size_t number) const {
    if (number >= frame_.parameterCount) return {};
    const std::uint32_t entry = frame_.parameters[number];
    return {bytesOf(pointerArea(entry)), pointerAddress(entry)};
  }
  Bytes bytesOf(Area area) const {
    switch (area) {
      case Area::Input:
      case Area::Output:
      case Area::Flag:
        return {m_.image + m_.areas.base(area), m_.areas.length(area)};
      case Area::DataBlock:
        return of(open_.db);
      case Area::Instance:
        return of(open_.di);
      case Area::CallerLocal:
        return frame_.first || index_ < 2 ? Bytes{} : localOf(m_.frames[index_ - 1]);
      default:
        return {};
    }
  }

  void add(const block::Variable& variable, Home home) {
    if (variable.type) addType(variable.name, sectionName(variable.section), *variable.type, home);
  }
  void addType(const std::string& name, const std::string& section, const block::Type& type,
               Home home) {
    if (rows_.size() >= kMostRows) return;
    if (type.code == TypeCode::Array) return addArray(name, section, type, home);
    if (type.code == TypeCode::Struct) return addMembers(name, section, type, home);
    FrameVariable row{name, section, block::toString(type), std::nullopt};
    if (isElementary(type.code))
      if (const auto bits = read(home, bitWidth(type.code)))
        row.value = formatValue(type.code, *bits);
    rows_.push_back(std::move(row));
  }
  void addArray(const std::string& name, const std::string& section, const block::Type& type,
                Home home) {
    const std::vector<BitAddress> places = block::elementOffsets(type);
    for (std::size_t i = 0; i < places.size() && rows_.size() < kMostRows; ++i)
      addType(name + indexText(type, i), section, *type.element,
              {home.bytes, home.address + places[i]});
  }
  void addMembers(const std::string& name, const std::string& section, const block::Type& type,
                  Home home) {
    for (const block::Variable& member : type.members)
      if (member.type)
        addType(name + "." + member.name, section, *member.type,
                {home.bytes, home.address + member.address});
  }
  // "[2,1]" for the element of this number; the last index runs fastest.
  static std::string indexText(const block::Type& type, std::size_t number) {
    std::string text;
    for (auto range = type.dimensions.rbegin(); range != type.dimensions.rend(); ++range) {
      const auto index = static_cast<std::int64_t>(number % range->count()) + range->low;
      text = std::to_string(index) + (text.empty() ? "" : "," + text);
      number /= range->count();
    }
    return "[" + text + "]";
  }

  const cpu::Machine& m_;
  std::size_t index_;
  const cpu::Frame& frame_;
  OpenBlocks open_;
  std::vector<FrameVariable> rows_;
};

}  // namespace

std::vector<FrameVariable> frameVariables(const cpu::Cpu& cpu, std::size_t depth) {
  const cpu::Machine& m = cpu.machine();
  if (depth + 1 >= m.frames.size()) return {};
  return Reader(m, m.frames.size() - 1 - depth).all();
}

}  // namespace merker::monitor
