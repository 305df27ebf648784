#include "awl/names.h"

#include <fmt/format.h>

#include "block/width.h"

namespace merker::awl {
namespace {

constexpr std::size_t kMostNames = 20'000;
constexpr int kDeepest = 8;

bool simple(const block::Type& type) {
  return isElementary(type.code) || isParameterNumber(type.code);
}

std::string indexText(const block::Type& array, std::size_t element) {
  std::string text;
  for (std::size_t d = array.dimensions.size(); d-- > 0;) {
    const block::Dimension& dimension = array.dimensions[d];
    const std::string index =
        std::to_string(dimension.low + static_cast<std::int32_t>(element % dimension.count()));
    text = text.empty() ? index : index + "," + text;
    element /= dimension.count();
  }
  return "[" + text + "]";
}

template <typename Visit>
void eachElement(const block::Variable& variable, const std::string& path, BitAddress at, int depth,
                 Visit visit) {
  const block::Type& type = *variable.type;
  if (simple(type)) {
    visit(path, at, type);
  } else if (depth < kDeepest && type.code == TypeCode::Array) {
    const auto offsets = block::elementOffsets(type);
    for (std::size_t i = 0; i < offsets.size() && i < kMostNames; ++i) {
      block::Variable element;
      element.type = type.element;
      eachElement(element, path + indexText(type, i), at + offsets[i], depth + 1, visit);
    }
  } else if (depth < kDeepest) {
    for (const block::Variable& member : type.members)
      eachElement(member, path + "." + member.name, at + member.address, depth + 1, visit);
  }
}

// The path of the part of `variable`, at `at`, that begins at `address`; empty if none does.
std::string partOf(const block::Variable& variable, const std::string& path, BitAddress at,
                   BitAddress address, const block::Type& type, bool anyType, int depth) {
  const block::Type& own = *variable.type;
  if (address < at || address >= at + block::sizeInBits(own) || depth > kDeepest) return {};
  if (address == at && (anyType || block::sameStructure(own, type))) return path;
  if (own.code == TypeCode::Array) {
    const auto offsets = block::elementOffsets(own);
    for (std::size_t i = 0; i < offsets.size(); ++i) {
      block::Variable element;
      element.type = own.element;
      std::string found = partOf(element, path + indexText(own, i), at + offsets[i], address, type,
                                 anyType, depth + 1);
      if (!found.empty()) return found;
    }
    return {};
  }
  for (const block::Variable& member : own.members) {
    std::string found = partOf(member, path + "." + member.name, at + member.address, address, type,
                               anyType, depth + 1);
    if (!found.empty()) return found;
  }
  return {};
}

}  // namespace

std::string partAt(const std::vector<block::Variable>& variables, BitAddress address,
                   const block::Type& type, bool anyType) {
  for (const block::Variable& v : variables) {
    if (v.section == block::Section::Temp) continue;
    std::string found = partOf(v, v.name, v.address, address, type, anyType, 0);
    if (!found.empty()) return found;
  }
  return {};
}

void Names::add(const block::Variable& variable, const std::string& path, BitAddress at,
                std::map<Key, std::string>& to, int depth) {
  eachElement(variable, path, at, depth,
              [&](const std::string& name, BitAddress place, const block::Type& type) {
                if (to.size() < kMostNames)
                  to.try_emplace({place, block::widthOf(type.code)}, name);
              });
}

Names::Names(const block::Block& block)
    : block_(block), fb_(block.id.kind == BlockKind::FB || block.id.kind == BlockKind::SFB) {
  const bool fc = block.id.kind == BlockKind::FC || block.id.kind == BlockKind::SFC;
  for (const block::Variable& v : block.variables) {
    if (v.section == block::Section::Temp)
      add(v, "#" + v.name, v.address, local_, 0);
    else if (fb_ && !block::isStoredAsPointer(v) && !isParameterNumber(v.type->code))
      add(v, "#" + v.name, v.address, instance_, 0);
  }
  if (fc)
    for (const block::Variable* p : block::parameters(block)) parameters_.push_back("#" + p->name);
}

std::string Names::parameter(std::uint32_t index) const {
  return index < parameters_.size() ? parameters_[index] : std::string();
}

std::string Names::of(const mc7::Operand& operand) const {
  using mc7::OperandKind;
  const auto find = [&](const std::map<Key, std::string>& names) {
    const auto at = names.find({operand.value, operand.width});
    return at == names.end() ? std::string() : at->second;
  };
  switch (operand.kind) {
    case OperandKind::Parameter:
    case OperandKind::TimerParameter:
    case OperandKind::CounterParameter:
    case OperandKind::BlockParameter:
      return parameter(operand.value);
    case OperandKind::ParameterAddress:
      return "P#" + parameter(operand.value);
    case OperandKind::Memory:
      return operand.area == Area::Local ? find(local_) : std::string();
    case OperandKind::RegisterIndirect:
      return fb_ && operand.area == Area::Instance && operand.reg == 2 ? find(instance_)
                                                                       : std::string();
    case OperandKind::None:
    case OperandKind::MemoryIndirect:
    case OperandKind::RegisterCrossing:
    case OperandKind::Timer:
    case OperandKind::TimerIndirect:
    case OperandKind::Counter:
    case OperandKind::CounterIndirect:
    case OperandKind::StatusBit:
    case OperandKind::StatusWord:
    case OperandKind::Constant:
    case OperandKind::Pointer:
    case OperandKind::AddressRegister:
    case OperandKind::ShiftCount:
    case OperandKind::Jump:
    case OperandKind::JumpList:
    case OperandKind::Block:
    case OperandKind::BlockIndirect:
    case OperandKind::DataBlockInfo:
      break;
  }
  return {};
}

const block::Variable* Names::local(BitAddress address) const {
  for (const block::Variable& v : block_.variables)
    if (v.section == block::Section::Temp && v.address == address) return &v;
  return nullptr;
}

const block::Variable* Names::instance(BitAddress address) const {
  for (const block::Variable& v : block_.variables)
    if (v.section != block::Section::Temp && v.address == address) return &v;
  return nullptr;
}

std::string memberAt(const std::vector<block::Variable>& variables, BitAddress address,
                     Width width) {
  std::string found;
  for (const block::Variable& v : variables)
    if (v.section != block::Section::Temp)
      eachElement(v, v.name, v.address, 0,
                  [&](const std::string& path, BitAddress at, const block::Type& type) {
                    if (found.empty() && at == address && block::widthOf(type.code) == width)
                      found = path;
                  });
  return found;
}

}  // namespace merker::awl
