#include <algorithm>
#include <array>
#include <optional>

#include "block/interface_part.h"

namespace merker::block {
namespace {

constexpr unsigned kDeepestNesting = 16;
constexpr std::uint32_t kLargestSize = bitAddress(0x10000);

// Little-endian bytes with an end; reading beyond it gives 0 and is remembered.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  bool empty() const { return at_ >= bytes_.size(); }
  bool overrun() const { return overrun_; }
  std::uint8_t byte() {
    if (!empty()) return bytes_[at_++];
    overrun_ = true;
    return 0;
  }
  std::uint16_t word() {
    const unsigned low = byte();
    return static_cast<std::uint16_t>(byte() << 8 | low);
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  bool overrun_ = false;
};

// What an entry says about its variable besides the type.
struct Entry {
  TypePtr type;
  Section section = Section::Static;
  bool hasValue = false;
};

std::string_view sectionName(Section section) {
  static constexpr std::array<std::string_view, 7> kNames{"",     "IN",   "OUT",    "IN_OUT",
                                                          "STAT", "TEMP", "RET_VAL"};
  return kNames[static_cast<std::size_t>(section)];
}

bool isSimple(TypeCode code) {
  return isElementary(code) || isParameterNumber(code) || code == TypeCode::DateAndTime ||
         code == TypeCode::Pointer || code == TypeCode::Any;
}

class Reader {
 public:
  Reader(BlockKind kind, std::span<const std::uint8_t> declarations,
         std::span<const std::uint8_t> values)
      : kind_(kind), declarations_(declarations), values_(values) {}

  bool atEnd() const { return declarations_.empty(); }
  // `fixed`: the section of the structure around it; members of an instance bring their own.
  std::optional<Variable> variable(std::optional<Section> fixed, unsigned depth);

 private:
  std::optional<Entry> entry(unsigned depth);
  bool head(Entry& entry);
  TypePtr array(Entry& outer, unsigned depth);
  TypePtr structure(bool instance, unsigned depth);
  TypePtr instance(TypeCode code, unsigned depth);
  std::vector<std::uint8_t> startValue(const Type& type);
  void element(const Type& type, BitAddress at, std::vector<std::uint8_t>& image);
  std::string nextName(Section section);

  BlockKind kind_;
  Bytes declarations_, values_;
  std::array<unsigned, 7> counters_{};
};

std::string Reader::nextName(Section section) {
  const unsigned number = counters_[static_cast<std::size_t>(section)]++;
  const std::string name{sectionName(section)};
  return section == Section::Return ? name : name + std::to_string(number);
}

bool Reader::head(Entry& entry) {
  const std::uint8_t mark = declarations_.byte();
  if ((mark & kExtended) != 0) declarations_.byte();
  entry.hasValue = (mark & kHasStartValue) != 0;
  const unsigned section = mark & 0x7u;
  entry.section = static_cast<Section>(section);
  return section >= 1 && section <= 6 && mark < 0x20;
}

TypePtr Reader::array(Entry& outer, unsigned depth) {
  std::vector<Dimension> dimensions(declarations_.byte());
  if (dimensions.empty() || dimensions.size() > 6) return nullptr;
  for (Dimension& d : dimensions) {
    d.low = static_cast<std::int16_t>(declarations_.word());
    d.high = static_cast<std::int16_t>(declarations_.word());
    if (d.low > d.high) return nullptr;
  }
  const auto inner = entry(depth + 1);
  if (!inner || sizeInBits(*inner->type) == 0) return nullptr;
  outer.hasValue = inner->hasValue;
  return arrayType(std::move(dimensions), inner->type);
}

TypePtr Reader::structure(bool ofInstance, unsigned depth) {
  unsigned count = declarations_.byte();
  if (count == 0xFF) count = declarations_.word();
  std::vector<Variable> members;
  for (unsigned i = 0; i < count; ++i) {
    auto member = variable(ofInstance ? std::nullopt : std::optional{Section::Static}, depth + 1);
    if (!member) return nullptr;
    if (isInstance(member->type->code) && ++i == count) return nullptr;
    members.push_back(std::move(*member));
  }
  return structType(std::move(members));
}

// A multiple instance names its FB; the structure of its data follows.
TypePtr Reader::instance(TypeCode code, unsigned depth) {
  const std::uint16_t number = declarations_.word();
  Entry data;
  if (static_cast<TypeCode>(declarations_.byte()) != TypeCode::Struct || !head(data))
    return nullptr;
  const TypePtr members = structure(true, depth);
  if (!members) return nullptr;
  Type type = *members;
  type.code = code;
  type.length = number;
  return std::make_shared<const Type>(std::move(type));
}

std::optional<Entry> Reader::entry(unsigned depth) {
  Entry result;
  if (depth > kDeepestNesting) return std::nullopt;
  const auto code = static_cast<TypeCode>(declarations_.byte());
  if (isInstance(code)) {
    result.type = instance(code, depth);
  } else if (!head(result)) {
    return std::nullopt;
  } else if (isSimple(code)) {
    result.type = elementaryType(code);
  } else if (code == TypeCode::String) {
    result.type = stringType(declarations_.byte());
  } else if (code == TypeCode::Array) {
    result.type = array(result, depth);
  } else if (code == TypeCode::Struct) {
    result.type = structure(false, depth);
  }
  const bool good =
      result.type && !declarations_.overrun() && sizeInBits(*result.type) <= kLargestSize;
  return good ? std::optional{result} : std::nullopt;
}

void Reader::element(const Type& type, BitAddress at, std::vector<std::uint8_t>& image) {
  std::uint8_t* bytes = image.data() + at / 8;
  const std::size_t count = sizeInBytes(type);
  if (type.code == TypeCode::Bool) {
    if (values_.byte() != 0) bytes[0] = static_cast<std::uint8_t>(bytes[0] | 1u << at % 8);
  } else if (type.code == TypeCode::String) {
    bytes[0] = values_.byte();
    bytes[1] = std::min(values_.byte(), static_cast<std::uint8_t>(type.length));
    for (unsigned i = 0; i < bytes[1]; ++i) bytes[2 + i] = values_.byte();
  } else if (type.code == TypeCode::DateAndTime) {
    for (std::size_t i = 0; i < count; ++i) bytes[i] = values_.byte();
  } else {
    for (std::size_t i = count; i-- > 0;) bytes[i] = values_.byte();
  }
}

std::vector<std::uint8_t> Reader::startValue(const Type& type) {
  std::vector<std::uint8_t> image(sizeInBytes(type));
  if (type.code != TypeCode::Array) {
    element(type, 0, image);
    return image;
  }
  for (const BitAddress offset : elementOffsets(type)) {
    if (values_.overrun()) break;
    element(*type.element, offset, image);
  }
  return image;
}

std::optional<Variable> Reader::variable(std::optional<Section> fixed, unsigned depth) {
  const auto found = entry(depth);
  if (!found) return std::nullopt;
  Variable v;
  v.section = fixed.value_or(found->section);
  v.name = nextName(found->section);
  v.type = found->type;
  const Type& leaf = v.type->code == TypeCode::Array ? *v.type->element : *v.type;
  const bool simple = isElementary(leaf.code) || leaf.code == TypeCode::DateAndTime ||
                      leaf.code == TypeCode::String;
  if (found->hasValue && simple) {
    v.initial = startValue(*v.type);
    // Members of a structure name the section of the whole.
    v.hasInitial =
        keepsStartValue(kind_, found->section, fixed.has_value() || isComposite(v.type->code));
    if (!v.hasInitial) v.initial.clear();
  }
  return values_.overrun() ? std::nullopt : std::optional{std::move(v)};
}

// Addresses as the compiler gives them: parameters and static data in one frame, local data in
// another.
bool place(std::vector<Variable>& variables, Block& block) {
  const auto temp =
      std::stable_partition(variables.begin(), variables.end(),
                            [](const Variable& v) { return v.section != Section::Temp; });
  std::vector<Variable> local(std::make_move_iterator(temp),
                              std::make_move_iterator(variables.end()));
  variables.erase(temp, variables.end());
  const BitAddress end = layOut(variables, 0, true);
  const BitAddress localEnd = layOut(local, 0, true);
  block.instanceBytes = end / 8;
  block.variables = std::move(variables);
  block.variables.insert(block.variables.end(), std::make_move_iterator(local.begin()),
                         std::make_move_iterator(local.end()));
  return end <= kLargestSize && localEnd <= kLargestSize;
}

}  // namespace

bool readInterface(std::span<const std::uint8_t> bytes, Block& block) {
  Bytes header(bytes);
  const auto kind = static_cast<InterfaceKind>(header.byte());
  const std::uint16_t number = header.word();
  const std::size_t declarationBytes = header.word(), valueBytes = header.word();
  if (header.overrun() || bytes.size() < kInterfaceHeader + declarationBytes + valueBytes)
    return false;
  if (kind == InterfaceKind::InstanceOfFb || kind == InterfaceKind::InstanceOfSfb)
    block.instanceOf = number;
  block.instanceOfSystemBlock = kind == InterfaceKind::InstanceOfSfb;

  Reader reader(block.id.kind, bytes.subspan(kInterfaceHeader, declarationBytes),
                bytes.subspan(kInterfaceHeader + declarationBytes, valueBytes));
  std::vector<Variable> variables;
  while (!reader.atEnd()) {
    auto variable = reader.variable(std::nullopt, 0);
    if (!variable) return false;
    if (variable->section == Section::Return) block.returnType = variable->type;
    variables.push_back(std::move(*variable));
  }
  return place(variables, block);
}

}  // namespace merker::block
