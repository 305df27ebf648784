#include <algorithm>

#include "block/interface_part.h"

namespace merker::block {
namespace {

using Bytes = std::vector<std::uint8_t>;

void appendLittle(Bytes& out, std::uint32_t value) {
  out.push_back(static_cast<std::uint8_t>(value));
  out.push_back(static_cast<std::uint8_t>(value >> 8));
}

// Declarations and start values grow side by side, both in the order of the variables.
class Writer {
 public:
  explicit Writer(BlockKind kind) : kind_(kind) {}
  // `nested`: a member of a structure.
  void variable(const Variable& v, Section section, bool nested = false);
  // Local data that begin behind 20 undeclared bytes of start information.
  void filler(std::uint32_t bytes);
  Bytes finish(InterfaceKind kind, std::uint32_t number) &&;

 private:
  void entry(const Type& type, Section section, bool hasValue);
  void head(TypeCode code, Section section, bool hasValue);
  void structure(const std::vector<Variable>& members, Section section, bool instance);
  void startValue(const Type& type, const Bytes& value, BitAddress at);

  BlockKind kind_;
  Bytes declarations_, values_;
};

bool hasStartValue(const Type& type, const Variable& v) {
  const Type& leaf = type.code == TypeCode::Array ? *type.element : type;
  const bool simple = isElementary(leaf.code) || leaf.code == TypeCode::DateAndTime ||
                      leaf.code == TypeCode::String;
  return simple && v.hasInitial && v.initial.size() * 8 >= sizeInBits(type);
}

void Writer::head(TypeCode code, Section section, bool hasValue) {
  declarations_.push_back(static_cast<std::uint8_t>(code));
  declarations_.push_back(
      static_cast<std::uint8_t>(static_cast<unsigned>(section) | (hasValue ? kHasStartValue : 0u)));
}

std::size_t countMembers(const std::vector<Variable>& members) {
  std::size_t count = members.size();
  for (const Variable& member : members) count += isInstance(member.type->code) ? 1 : 0;
  return count;
}

void Writer::structure(const std::vector<Variable>& members, Section section, bool instance) {
  head(TypeCode::Struct, section, false);
  const std::size_t count = countMembers(members);
  declarations_.push_back(static_cast<std::uint8_t>(std::min<std::size_t>(count, 0xFF)));
  if (count >= 0xFF) appendLittle(declarations_, static_cast<std::uint32_t>(count));
  for (const Variable& member : members)
    variable(member, instance ? member.section : section, !instance);
}

// BOOL as one byte, numbers little-endian, DT as it is, STRING with its lengths up to the last used
// character.
void Writer::startValue(const Type& type, const Bytes& value, BitAddress at) {
  const std::uint8_t* bytes = value.data() + at / 8;
  const std::size_t count = sizeInBytes(type);
  if (type.code == TypeCode::Bool) {
    values_.push_back(bytes[0] >> at % 8 & 1);
  } else if (type.code == TypeCode::String) {
    values_.insert(values_.end(), bytes,
                   bytes + 2 + std::min(bytes[1], static_cast<std::uint8_t>(type.length)));
  } else if (type.code == TypeCode::DateAndTime) {
    values_.insert(values_.end(), bytes, bytes + count);
  } else {
    values_.insert(values_.end(), std::reverse_iterator(bytes + count),
                   std::reverse_iterator(bytes));
  }
}

void Writer::entry(const Type& type, Section section, bool hasValue) {
  if (type.code == TypeCode::Struct) return structure(type.members, section, false);
  if (isInstance(type.code)) {
    declarations_.push_back(static_cast<std::uint8_t>(type.code));
    appendLittle(declarations_, type.length);
    return structure(type.members, section, true);
  }
  head(type.code, section, type.code != TypeCode::Array && hasValue);
  if (type.code == TypeCode::String)
    declarations_.push_back(static_cast<std::uint8_t>(type.length));
  if (type.code != TypeCode::Array) return;
  declarations_.push_back(static_cast<std::uint8_t>(type.dimensions.size()));
  for (const Dimension& d : type.dimensions) {
    appendLittle(declarations_, static_cast<std::uint32_t>(d.low));
    appendLittle(declarations_, static_cast<std::uint32_t>(d.high));
  }
  entry(*type.element, section, hasValue);
}

void Writer::variable(const Variable& v, Section section, bool nested) {
  const bool hasValue = hasStartValue(*v.type, v) &&
                        keepsStartValue(kind_, section, nested || isComposite(v.type->code));
  entry(*v.type, section, hasValue);
  if (!hasValue) return;
  if (v.type->code != TypeCode::Array) return startValue(*v.type, v.initial, 0);
  for (const BitAddress offset : elementOffsets(*v.type))
    startValue(*v.type->element, v.initial, offset);
}

void Writer::filler(std::uint32_t bytes) {
  Variable v;
  v.type = arrayType({{1, static_cast<std::int32_t>(bytes)}}, elementaryType(TypeCode::Byte));
  variable(v, Section::Temp);
}

Bytes Writer::finish(InterfaceKind kind, std::uint32_t number) && {
  Bytes out{static_cast<std::uint8_t>(kind)};
  appendLittle(out, number);
  appendLittle(out, static_cast<std::uint32_t>(declarations_.size()));
  appendLittle(out, static_cast<std::uint32_t>(values_.size()));
  out.insert(out.end(), declarations_.begin(), declarations_.end());
  out.insert(out.end(), values_.begin(), values_.end());
  if (out.size() % 2 != 0) out.push_back(0);
  return out;
}

InterfaceKind kindOf(const Block& block) {
  if (block.id.kind != BlockKind::DB) return InterfaceKind::Code;
  if (block.instanceOf < 0) return InterfaceKind::Data;
  return block.instanceOfSystemBlock ? InterfaceKind::InstanceOfSfb : InterfaceKind::InstanceOfFb;
}

}  // namespace

std::vector<std::uint8_t> writeInterface(const Block& block) {
  Writer writer(block.id.kind);
  bool first = true;
  for (const Variable& v : block.variables) {
    const bool temp = v.section == Section::Temp;
    if (temp && first && v.address > 0) writer.filler(v.address / 8);
    if (temp) first = false;
    writer.variable(v, v.section);
  }
  const std::uint32_t number =
      block.instanceOf >= 0 ? static_cast<std::uint32_t>(block.instanceOf) : block.id.number;
  return std::move(writer).finish(kindOf(block), number);
}

}  // namespace merker::block
