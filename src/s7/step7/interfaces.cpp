#include "step7/interfaces.h"

#include <algorithm>
#include <set>

#include "base/text.h"
#include "step7/initial_value.h"
#include "step7/other_cpus.h"
#include "step7/path.h"

namespace merker::step7 {

using block::Section;

namespace {

// STEP 7 nests 8 levels, a data block has 64 KB: what is far beyond is refused before it takes time
// and room. The limits hold for types with problems, too, whose parts may have no size.
constexpr int kDeepest = 32;
constexpr std::uint64_t kMostParts = 1'000'000;
constexpr std::uint32_t kLargestType = 0x10'0000;
// Of all blocks together.
constexpr std::uint64_t kMostInitialBytes = 64 * 1024 * 1024;

// Far below what could wrap around.
std::uint64_t elements(const std::vector<block::Dimension>& dimensions) {
  std::uint64_t count = 1;
  for (const block::Dimension& dimension : dimensions)
    count = std::min<std::uint64_t>(count * dimension.count(), 1'000'000'000);
  return count;
}

// A type whose declaration has a problem: it takes no place, and its uses are no further problems.
block::TypePtr unknownType() { return block::elementaryType(TypeCode::Void); }

}  // namespace

Interfaces::Interfaces(std::vector<BlockSource>& sources, const CompileOptions& options,
                       Problems& problems)
    : options_(options), problems_(problems) {
  for (BlockSource& source : sources) {
    auto [entry, added] = entries_.try_emplace(source.id, Entry{&source, State::Open});
    if (!added) {
      const Position first = at(*entry->second.source, entry->second.source->name.begin,
                                entry->second.source->name.end);
      problems_.add(ProblemCode::P0501, at(source, source.name.begin, source.name.end),
                    toString(source.id), first.file, first.line);
      source.duplicate = true;
    }
    if (!options.model->allows(source.id))
      problems_.add(ProblemCode::P0502, at(source, source.name.begin, source.name.end),
                    toString(source.id), options.model->name);
  }
}

void Interfaces::resolveAll() {
  for (auto& [id, entry] : entries_)
    if (!problems_.cancelled()) resolve(id);
}

bool Interfaces::unknown(BlockId id) const {
  const auto entry = entries_.find(id);
  return entry != entries_.end() && entry->second.unknown;
}

bool Interfaces::busy(BlockId id) const {
  const auto entry = entries_.find(id);
  return entry != entries_.end() && entry->second.state == State::Busy;
}

const block::Block* Interfaces::find(BlockId id) {
  if (const block::Block* own = resolve(id)) return own;
  if (!options_.library) return nullptr;
  const auto found = options_.library->find(id);
  if (found != options_.library->end()) return &found->second;
  // A generic CPU stands for any.
  return options_.model->hotRestart ? functionOfOtherCpu(id) : nullptr;
}

const BlockNames& Interfaces::names(const block::Block& block) {
  return names_.try_emplace(block.id, block).first->second;
}

const block::Block* Interfaces::resolve(BlockId id) {
  const auto found = entries_.find(id);
  if (found == entries_.end()) return nullptr;
  Entry& entry = found->second;
  if (entry.state == State::Done) return &program_.at(id);
  BlockSource& source = *entry.source;
  if (entry.state == State::Busy) return nullptr;
  if (depth_ >= kDeepest) {
    problems_.add(ProblemCode::P0202, at(source, source.name.begin, source.name.end),
                  "the nesting of types", fmt::format("1..{}", kDeepest));
    return nullptr;
  }
  ++depth_;
  entry.state = State::Busy;
  block::Block result;
  result.id = id;
  result.symbol = source.name.symbol;
  result.attributes = source.attributes;
  result.file = source.file->name();
  const bool data = id.kind == BlockKind::DB || id.kind == BlockKind::UDT;
  if (data)
    resolveData(source, result);
  else
    resolveCode(source, result);
  // The instance of an FB that declares nothing is empty, and known.
  entry.unknown = data && result.variables.empty() && result.instanceOf < 0;
  --depth_;
  entry.state = State::Done;
  return &program_.emplace(id, std::move(result)).first->second;
}

block::TypePtr Interfaces::typeOf(const BlockSource& source, const VariableSyntax& syntax) {
  if (syntax.type.use_count() == 1) return type(source, *syntax.type, syntax.section);
  block::TypePtr& known = types_[syntax.type.get()];
  if (!known) known = type(source, *syntax.type, syntax.section);
  return known;
}

Interfaces::Extent Interfaces::extent(const block::TypePtr& type) {
  if (!type->element && type->members.empty()) return {};
  if (const auto known = extents_.find(type); known != extents_.end()) return known->second;
  Extent whole;
  const auto add = [&](const block::TypePtr& part, std::uint64_t count) {
    const Extent one = extent(part);
    whole.parts = std::min(whole.parts + count * one.parts, kMostParts + 1);
    whole.depth = std::max(whole.depth, one.depth + 1);
  };
  const bool flat = type->element && isElementary(type->element->code);
  if (type->element) add(type->element, flat ? 1 : elements(type->dimensions));
  for (const block::Variable& member : type->members) add(member.type, 1);
  return extents_.emplace(type, whole).first->second;
}

block::TypePtr Interfaces::limited(block::TypePtr type, const Position& place) {
  const Extent found = extent(type);
  if (found.depth > kDeepest)
    problems_.add(ProblemCode::P0202, place, "the nesting of types",
                  fmt::format("1..{}", kDeepest));
  else if (found.parts > kMostParts)
    problems_.add(ProblemCode::P0106, place, kMostParts, "components in this type");
  else if (block::sizeInBytes(*type) > kLargestType)
    problems_.add(ProblemCode::P0106, place, kLargestType, "bytes in this type");
  else
    return type;
  return unknownType();
}

bool Interfaces::take(std::uint64_t& used, std::uint64_t more, std::uint64_t limit,
                      std::string_view what, const Position& place) {
  const bool before = used <= limit;
  used += more;
  if (used <= limit) return true;
  if (before) problems_.add(ProblemCode::P0106, place, limit, what);
  return false;
}

void Interfaces::checkDuplicates(const BlockSource& source,
                                 const std::vector<VariableSyntax>& variables) {
  std::set<std::string> names;
  for (const VariableSyntax& variable : variables)
    if (!names.insert(upper(variable.name)).second)
      problems_.add(ProblemCode::P0422,
                    at(source, variable.begin, variable.begin + variable.name.size()),
                    variable.name);
}

block::Variable Interfaces::variable(const BlockSource& source, const VariableSyntax& syntax) {
  block::Variable result;
  result.name = syntax.name;
  result.section = syntax.section;
  result.comment = syntax.comment;
  result.attributes = syntax.attributes;
  result.position = at(source, syntax.begin, syntax.begin + syntax.name.size());
  if (characterCount(syntax.name) > 24)  // S7-SRC-10
    problems_.add(ProblemCode::P0423, result.position, syntax.name);
  result.type = typeOf(source, syntax);
  if (syntax.section == Section::InOut) checkNoInitials(source, *syntax.type);
  if (syntax.initialEnd > syntax.initialBegin) {
    checkInitial(source, syntax);
    const bool known = result.type->code != TypeCode::Array || block::sizeInBits(*result.type) > 0;
    if (!known || !take(initialBytes_, block::sizeInBytes(*result.type), kMostInitialBytes,
                        "bytes of start values", result.position))
      return result;
    if (const auto bytes = readInitialValue(*result.type, *source.file, syntax.initialBegin,
                                            syntax.initialEnd, source.mnemonics, problems_)) {
      result.initial = *bytes;
      result.hasInitial = true;
    }
  }
  return result;
}

// S7-SRC-04: no start values for FC parameters, temporary variables, composite in/out parameters.
void Interfaces::checkInitial(const BlockSource& source, const VariableSyntax& variable) {
  const bool ofFunction = source.id.kind == BlockKind::FC && variable.section != Section::Temp;
  const bool composite =
      variable.section == Section::InOut && variable.type->kind != TypeSyntax::Kind::Elementary;
  if (variable.section != Section::Temp && !ofFunction && !composite) return;
  problems_.add(ProblemCode::P0424, at(source, variable.initialBegin, variable.initialEnd),
                variable.name);
}

void Interfaces::checkNoInitials(const BlockSource& source, const TypeSyntax& type) {
  const TypeSyntax* last = nullptr;  // those of several names are told once
  for (const VariableSyntax& member : type.members) {
    if (member.type.get() == last) continue;
    last = member.type.get();
    if (member.initialEnd > member.initialBegin)
      problems_.add(ProblemCode::P0424, at(source, member.initialBegin, member.initialEnd),
                    member.name);
    checkNoInitials(source, *member.type);
  }
  if (type.element) checkNoInitials(source, *type.element);
}

block::TypePtr Interfaces::structure(const BlockSource& source, const TypeSyntax& syntax) {
  checkDuplicates(source, syntax.members);
  std::vector<block::Variable> members;
  for (const VariableSyntax& member : syntax.members) members.push_back(variable(source, member));
  if (members.empty() && syntax.good)
    problems_.add(ProblemCode::P0425, at(source, syntax.begin, syntax.begin + 6));
  return limited(block::structType(std::move(members)), at(source, syntax.begin, syntax.begin + 6));
}

// Where a parameter type is possible if not in this section, otherwise nothing (S7-TYPES-22). An FB
// keeps its parameters in the instance and has no way to hand a pointer out.
static std::string_view placesOf(TypeCode code, BlockKind kind, Section section) {
  const bool function = kind == BlockKind::FC || kind == BlockKind::SFC;
  const bool any = code == TypeCode::Any, pointer = code == TypeCode::Pointer;
  if (isParameterNumber(code))
    return section == Section::Input || section == Section::InOut ? "" : "a VAR_INPUT";
  if ((!any && !pointer) || section == Section::Input || section == Section::InOut) return "";
  if (any && section == Section::Temp) return "";
  if (function && section != Section::Static && section != Section::Temp) return "";
  return function ? "a parameter: VAR_INPUT, VAR_OUTPUT, VAR_IN_OUT"
                  : "a VAR_INPUT or VAR_IN_OUT of a function or function block";
}

block::TypePtr Interfaces::type(const BlockSource& source, const TypeSyntax& syntax,
                                Section section) {
  const Position place = at(source, syntax.begin, syntax.end);
  if (!syntax.good && syntax.kind == TypeSyntax::Kind::Elementary) return unknownType();
  switch (syntax.kind) {
    case TypeSyntax::Kind::Elementary: {
      const block::TypePtr result = block::elementaryType(syntax.code);
      const std::string_view where = placesOf(syntax.code, source.id.kind, section);
      if (where.empty()) return result;
      problems_.add(ProblemCode::P0426, place, block::toString(*result), where);
      return unknownType();
    }
    case TypeSyntax::Kind::String:
      return block::stringType(syntax.length);
    case TypeSyntax::Kind::Array: {
      block::TypePtr element = type(source, *syntax.element, Section::Static);
      const std::uint64_t count = elements(syntax.dimensions);
      if (count * std::max(1u, block::sizeInBits(*element)) / 8 > 65'536) {
        problems_.add(ProblemCode::P0427, place, count);
        return unknownType();
      }
      return limited(block::arrayType(syntax.dimensions, std::move(element)), place);
    }
    case TypeSyntax::Kind::Struct:
      return structure(source, syntax);
    case TypeSyntax::Kind::Block:
      return blockType(source, syntax, syntax.block, section);
    case TypeSyntax::Kind::Symbol: {
      const source::Symbol* symbol =
          options_.symbols ? options_.symbols->find(syntax.symbol) : nullptr;
      if (symbol && symbol->address.kind == source::SymbolAddress::Kind::Block)
        return blockType(source, syntax, symbol->address.block, section);
      if (missing_.emplace(source.id, syntax.symbol).second)
        problems_.add(symbol ? ProblemCode::P0304 : ProblemCode::P0303, place, syntax.symbol);
      return unknownType();
    }
  }
  return unknownType();
}

block::TypePtr Interfaces::blockType(const BlockSource& source, const TypeSyntax& syntax,
                                     BlockId id, Section section) {
  const Position place = at(source, syntax.begin, syntax.end);
  if (busy(id)) {
    problems_.add(ProblemCode::P0421, place, toString(id));
    return unknownType();
  }
  if (id.kind == BlockKind::UDT) {
    const block::Block* udt = find(id);
    if (udt && !udt->variables.empty()) return udt->variables.front().type;
    if (!udt) missing(source, place, id);
    return unknownType();
  }
  // S7-PAR-10: instances only as static variables of an FB.
  const bool instance = (id.kind == BlockKind::FB || id.kind == BlockKind::SFB);
  if (!instance || section != Section::Static ||
      (source.id.kind != BlockKind::FB && source.id.kind != BlockKind::SFB)) {
    problems_.add(ProblemCode::P0429, place, toString(id));
    return unknownType();
  }
  if (block::TypePtr result = instanceType(id)) return limited(std::move(result), place);
  missing(source, place, id);
  return unknownType();
}

void Interfaces::missing(const BlockSource& source, const Position& place, BlockId id) {
  if (entries_.contains(id)) return;  // it is there, but nested too deep
  if (!missing_.emplace(source.id, toString(id)).second) return;
  if (id.kind == BlockKind::SFB)
    problems_.add(ProblemCode::P0433, place, options_.model->name, toString(id));
  else
    problems_.add(ProblemCode::P0428, place, toString(id));
}

block::TypePtr Interfaces::instanceType(BlockId id) {
  if (const auto known = instanceTypes_.find(id); known != instanceTypes_.end())
    return known->second;
  const block::Block* fb = find(id);
  if (!fb) return nullptr;
  std::vector<block::Variable> members;
  for (const block::Variable& variable : fb->variables)
    if (variable.section != Section::Temp) members.push_back(variable);
  auto type = std::make_shared<block::Type>();
  type->code = id.kind == BlockKind::FB ? TypeCode::FunctionBlock : TypeCode::SystemFunctionBlock;
  type->length = id.number;
  type->members = std::move(members);
  type->bits = fb->instanceBytes * 8;
  instanceTypes_[id] = type;
  return type;
}

void Interfaces::resolveCode(BlockSource& source, block::Block& result) {
  checkDuplicates(source, source.variables);
  for (const VariableSyntax& syntax : source.variables)
    result.variables.push_back(variable(source, syntax));
  const bool returns =
      source.returnType && (source.returnType->kind != TypeSyntax::Kind::Elementary ||
                            source.returnType->code != TypeCode::Void);
  if (returns) {
    result.returnType = type(source, *source.returnType, Section::Input);
    block::Variable value;
    value.name = "RET_VAL";
    value.section = Section::Return;
    value.type = result.returnType;
    const auto firstTemp =
        std::find_if(result.variables.begin(), result.variables.end(),
                     [](const block::Variable& v) { return v.section == Section::Temp; });
    result.variables.insert(firstTemp, std::move(value));
  }
  layOutSections(source, result);
}

// The first 20 bytes of an OB's local data are its start information (S7-OBI-01). A source may
// declare them, as STEP 7 writes it; otherwise its own variables begin behind them (S7-FC-09).
bool Interfaces::hasStartInformation(const std::vector<block::Variable>& temps) const {
  if (temps.empty()) return false;
  const std::string first = upper(temps.front().name);
  std::size_t i = 2;
  while (i < first.size() && isDigit(first[i])) ++i;
  if (first.starts_with("OB") && i > 2 && i < first.size() && first[i] == '_') return true;
  if (block::sizeInBytes(*temps.front().type) == 20) return true;
  for (const block::Variable& variable : temps)
    if (variable.address == bitAddress(12)) return variable.type->code == TypeCode::DateAndTime;
  return false;
}

void Interfaces::layOutSections(BlockSource& source, block::Block& result) {
  std::vector<block::Variable> parameters, temps;
  for (block::Variable& variable : result.variables)
    (variable.section == Section::Temp ? temps : parameters).push_back(std::move(variable));
  const bool instance = source.id.kind == BlockKind::FB || source.id.kind == BlockKind::SFB;
  result.instanceBytes = block::layOut(parameters, 0, true) / 8;
  BitAddress start = 0;
  BitAddress end = block::layOut(temps, start, true);
  if (source.id.kind == BlockKind::OB) {
    if (!temps.empty() && !hasStartInformation(temps))
      end = block::layOut(temps, bitAddress(20), true);
    end = std::max(end, bitAddress(20));
  }
  result.localBytes = end / 8;
  result.variables = std::move(parameters);
  result.variables.insert(result.variables.end(), std::make_move_iterator(temps.begin()),
                          std::make_move_iterator(temps.end()));
  if (instance && result.instanceBytes > options_.model->dataBlockSize)
    problems_.add(ProblemCode::P0503, at(source, source.name.begin, source.name.end),
                  toString(source.id), result.instanceBytes, options_.model->dataBlockSize);
}

}  // namespace merker::step7
