#include "monitor/frame_variables.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "address/constant.h"
#include "base/bytes.h"
#include "cpu/memory_access.h"
#include "monitor/stacks.h"
#include "scenario/long_value.h"

namespace merker::monitor {
namespace {

struct Bytes {
  const std::uint8_t* data = nullptr;
  std::size_t length = 0;
  // As an operand names them; None: it cannot.
  Area area = Area::None;
  std::int32_t db = -1;
};

// Where a variable lies: bytes and the bit address in them.
struct Home {
  Bytes bytes;
  BitAddress address = 0;
};

constexpr std::uint32_t kStringHeader = 2;  // S7-TYPES-19

// The bytes of a variable; empty if they are not there.
std::span<const std::uint8_t> bytesAt(const Home& home, std::size_t count) {
  const std::size_t byte = home.address / 8;
  if (home.bytes.data == nullptr || byte + count > home.bytes.length) return {};
  return {home.bytes.data + byte, count};
}

Width widthOf(unsigned bits) {
  return bits == 1 ? Width::Bit : bits == 8 ? Width::Byte : bits == 16 ? Width::Word : Width::DWord;
}

bool isLong(TypeCode code) { return code == TypeCode::String || code == TypeCode::DateAndTime; }

// A STRING that was handed over may be shorter than the parameter is declared.
std::uint32_t sizeAt(const Home& home, const block::Type& type) {
  const std::uint32_t declared = block::sizeInBytes(type);
  const auto header = bytesAt(home, kStringHeader);
  if (type.code != TypeCode::String || header.empty()) return declared;
  return std::min<std::uint32_t>(declared, header[0] + kStringHeader);
}

std::optional<std::string> valueAt(const Home& home, const block::Type& type) {
  const auto bytes = bytesAt(home, sizeAt(home, type));
  if (bytes.empty()) return std::nullopt;
  if (type.code == TypeCode::Bool)
    return formatValue(type.code, bytes[0] >> (home.address & 7) & 1u);
  if (isElementary(type.code))
    return formatValue(type.code, cpu::loadBytes(bytes.data(), widthOf(bitWidth(type.code))));
  if (!isLong(type.code)) return std::nullopt;
  const bool string = type.code == TypeCode::String;
  const std::string all(bytes.begin(), bytes.end());
  return simulator::formatLong(type.code, string ? all.substr(kStringHeader, bytes[1]) : all);
}

std::optional<address::Reference> operandAt(const Home& home, const block::Type& type,
                                            const std::string& name) {
  const bool wide = isLong(type.code);
  if (home.bytes.area == Area::None || (!wide && !isElementary(type.code))) return std::nullopt;
  const Width width = wide ? Width::Byte : widthOf(bitWidth(type.code));
  return address::Reference{.text = "#" + name,
                            .operand = address::memory(home.bytes.area, width, home.address),
                            .db = home.bytes.db,
                            .type = type.code,
                            .bytes = wide ? sizeAt(home, type) : 0};
}

Bytes of(const cpu::OpenBlock& open) {
  return {open.data, open.length, open.number == 0 ? Area::None : Area::DataBlock, open.number};
}
// `area`: L of the running block, V of its caller; None for all others.
Bytes localOf(const cpu::Frame& frame, Area area) {
  return {frame.local, frame.localLength, area, -1};
}

std::string sectionName(block::Section section) {
  constexpr std::string_view kNames[] = {"", "IN", "OUT", "IN_OUT", "STAT", "TEMP", "RETURN"};
  return std::string(kNames[static_cast<std::size_t>(section)]);
}

class Reader {
 public:
  Reader(const cpu::Machine& m, std::size_t frame, std::size_t most)
      : m_(m),
        most_(most),
        index_(frame),
        running_(frame + 1 == m.frames.size()),
        frame_(m.frames[frame]),
        open_(openBlocks(m, frame)) {}

  std::vector<FrameVariable> all() {
    const block::Block& block = *frame_.code->source;
    const bool function = block.id.kind == BlockKind::FC;
    const std::vector<const block::Variable*> list = block::parameters(block);
    for (std::size_t i = 0; function && i < list.size(); ++i) addParameter(*list[i], parameter(i));
    for (const block::Variable& variable : block.variables) {
      if (variable.section == block::Section::Temp)
        add(variable, {localOf(frame_, running_ ? Area::Local : Area::None), variable.address});
      else if (!function)
        addInstance(variable, {of(open_.di), pointerAddress(open_.ar2) + variable.address});
    }
    return std::move(rows_);
  }

  std::optional<std::uint32_t> bits(const std::string& name) const {
    const block::Block& block = *frame_.code->source;
    const auto at = std::ranges::find_if(
        block.variables, [&name](const block::Variable& one) { return one.name == name; });
    if (at == block.variables.end() || !at->type || !isElementary(at->type->code))
      return std::nullopt;
    const Home home = homeOf(block, *at);
    const auto bytes = bytesAt(home, block::sizeInBytes(*at->type));
    if (bytes.empty()) return std::nullopt;
    if (at->type->code == TypeCode::Bool) return bytes[0] >> (home.address & 7) & 1u;
    return cpu::loadBytes(bytes.data(), widthOf(bitWidth(at->type->code)));
  }

 private:
  Home homeOf(const block::Block& block, const block::Variable& variable) const {
    if (variable.section == block::Section::Temp)
      return {localOf(frame_, Area::Local), variable.address};
    if (block.id.kind != BlockKind::FC)
      return {of(open_.di), pointerAddress(open_.ar2) + variable.address};
    const auto list = block::parameters(block);
    const auto at = std::ranges::find(list, &variable);
    return at == list.end() ? Home{} : parameter(static_cast<std::size_t>(at - list.begin()));
  }
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
        return {m_.image + m_.areas.base(area), m_.areas.length(area), area, -1};
      case Area::DataBlock:
        return of(open_.db);
      case Area::Instance:
        return of(open_.di);
      case Area::CallerLocal:
        if (frame_.first || index_ < 2) return {};
        return localOf(m_.frames[index_ - 1], running_ ? Area::CallerLocal : Area::None);
      default:
        return {};
    }
  }

  // What a POINTER names: number of a data block and area pointer (S7-IND-11).
  Home target(const Home& pointer) const {
    constexpr std::size_t kPointer = 6;
    const auto bytes = bytesAt(pointer, kPointer);
    if (bytes.empty()) return {};
    const std::uint32_t db = loadWord(bytes.data()), where = loadDWord(&bytes[2]);
    if (db == 0) return {bytesOf(pointerArea(where)), pointerAddress(where)};
    const std::vector<cpu::DataBlock>& blocks = m_.dataBlocks.all();
    if (db >= blocks.size() || !blocks[db].loaded) return {};
    const std::vector<std::uint8_t>& data = blocks[db].data;
    return {{data.data(), data.size(), Area::DataBlock, static_cast<std::int32_t>(db)},
            pointerAddress(where)};
  }

  // Parameters that are handed over as a number or an ANY have no value here.
  void addParameter(const block::Variable& variable, Home home) {
    if (!variable.type) return;
    const TypeCode code = variable.type->code;
    const bool number =
        isParameterNumber(code) || code == TypeCode::Any || code == TypeCode::Pointer;
    add(variable, number ? Home{} : isElementary(code) ? home : target(home));
  }
  void addInstance(const block::Variable& variable, Home home) {
    add(variable, block::isStoredAsPointer(variable) ? target(home) : home);
  }
  void add(const block::Variable& variable, Home home) {
    if (variable.type) addType(variable.name, sectionName(variable.section), *variable.type, home);
  }
  void addType(const std::string& name, const std::string& section, const block::Type& type,
               Home home) {
    if (rows_.size() >= most_) return;
    if (type.code == TypeCode::Array) return addArray(name, section, type, home);
    if (!type.members.empty()) return addMembers(name, section, type, home);
    rows_.push_back(
        {name, section, block::toString(type), valueAt(home, type), operandAt(home, type, name)});
  }
  void addArray(const std::string& name, const std::string& section, const block::Type& type,
                Home home) {
    const std::vector<BitAddress> places = block::elementOffsets(type);
    for (std::size_t i = 0; i < places.size() && rows_.size() < most_; ++i)
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
  std::size_t most_, index_;
  bool running_;
  const cpu::Frame& frame_;
  OpenBlocks open_;
  std::vector<FrameVariable> rows_;
};

}  // namespace

std::optional<std::uint32_t> localBits(const cpu::Machine& machine, const std::string& name) {
  if (machine.frames.empty() || machine.frames.back().code == nullptr) return std::nullopt;
  return Reader(machine, machine.frames.size() - 1, 0).bits(name);
}

std::vector<FrameVariable> frameVariables(const cpu::Cpu& cpu, std::size_t depth,
                                          std::size_t most) {
  const cpu::Machine& m = cpu.machine();
  if (depth + 1 >= m.frames.size()) return {};
  return Reader(m, m.frames.size() - 1 - depth, most).all();
}

}  // namespace merker::monitor
