#include "step7/interfaces.h"

#include <algorithm>
#include <set>

#include "base/text.h"
#include "step7/initial_value.h"
#include "step7/path.h"

namespace merker::step7 {

using block::Section;

Interfaces::Interfaces(std::vector<BlockSource>& sources, const CompileOptions& options,
                       Problems& problems)
    : options_(options), problems_(problems) {
  for (BlockSource& source : sources) {
    auto [entry, added] =
        entries_.try_emplace(source.id, Entry{&source, State::Open, source.faulty});
    if (!added) {
      const Position first = at(*entry->second.source, entry->second.source->name.begin,
                                entry->second.source->name.end);
      problems_.add(ProblemCode::P0501, at(source, source.name.begin, source.name.end),
                    toString(source.id), first.file, first.line);
      source.faulty = true;
    }
    if (!options.model->allows(source.id))
      problems_.add(ProblemCode::P0502, at(source, source.name.begin, source.name.end),
                    toString(source.id), options.model->name);
  }
}

void Interfaces::resolveAll() {
  for (auto& [id, entry] : entries_) resolve(id);
}

bool Interfaces::faulty(BlockId id) const {
  const auto entry = entries_.find(id);
  return entry == entries_.end() || entry->second.faulty;
}

const block::Block* Interfaces::find(BlockId id) {
  if (const block::Block* own = resolve(id)) return own;
  if (!options_.library) return nullptr;
  const auto found = options_.library->find(id);
  return found == options_.library->end() ? nullptr : &found->second;
}

const block::Block* Interfaces::resolve(BlockId id) {
  const auto found = entries_.find(id);
  if (found == entries_.end()) return nullptr;
  Entry& entry = found->second;
  if (entry.state == State::Done) return &program_.at(id);
  BlockSource& source = *entry.source;
  if (entry.state == State::Busy) {
    problems_.add(ProblemCode::P0421, at(source, source.name.begin, source.name.end), toString(id));
    entry.faulty = true;
    return nullptr;
  }
  constexpr int kDeepest = 32;
  if (depth_ >= kDeepest) {
    problems_.add(ProblemCode::P0202, at(source, source.name.begin, source.name.end),
                  "the nesting of types", fmt::format("1..{}", kDeepest));
    entry.faulty = true;
    return nullptr;
  }
  ++depth_;
  entry.state = State::Busy;
  const std::size_t before = problems_.size();
  block::Block result;
  result.id = id;
  result.symbol = source.name.symbol;
  result.attributes = source.attributes;
  result.file = source.file->name();
  if (id.kind == BlockKind::DB || id.kind == BlockKind::UDT)
    resolveData(source, result);
  else
    resolveCode(source, result);
  entry.faulty = entry.faulty || problems_.size() != before;
  --depth_;
  entry.state = State::Done;
  return &program_.emplace(id, std::move(result)).first->second;
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
  result.type = type(source, syntax.type, syntax.section);
  if (syntax.section == Section::InOut) checkNoInitials(source, syntax.type);
  if (syntax.initialEnd > syntax.initialBegin) {
    checkInitial(source, syntax);
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
      variable.section == Section::InOut && variable.type.kind != TypeSyntax::Kind::Elementary;
  if (variable.section != Section::Temp && !ofFunction && !composite) return;
  problems_.add(ProblemCode::P0424, at(source, variable.initialBegin, variable.initialEnd),
                variable.name);
}

void Interfaces::checkNoInitials(const BlockSource& source, const TypeSyntax& type) {
  for (const VariableSyntax& member : type.members) {
    if (member.initialEnd > member.initialBegin)
      problems_.add(ProblemCode::P0424, at(source, member.initialBegin, member.initialEnd),
                    member.name);
    checkNoInitials(source, member.type);
  }
  if (type.element) checkNoInitials(source, *type.element);
}

block::TypePtr Interfaces::structure(const BlockSource& source, const TypeSyntax& syntax) {
  checkDuplicates(source, syntax.members);
  std::vector<block::Variable> members;
  for (const VariableSyntax& member : syntax.members) members.push_back(variable(source, member));
  if (members.empty() && !source.faulty)
    problems_.add(ProblemCode::P0425, at(source, syntax.begin, syntax.begin + 6));
  return block::structType(std::move(members));
}

block::TypePtr Interfaces::type(const BlockSource& source, const TypeSyntax& syntax,
                                Section section) {
  const Position place = at(source, syntax.begin, syntax.end);
  switch (syntax.kind) {
    case TypeSyntax::Kind::Elementary: {
      const bool parameterType = isParameterNumber(syntax.code) || syntax.code == TypeCode::Pointer;
      const bool parameter = section <= Section::InOut;
      const bool any = syntax.code == TypeCode::Any && section == Section::Static;
      if ((parameterType && !parameter) || any ||
          (isParameterNumber(syntax.code) && section == Section::Output))
        problems_.add(ProblemCode::P0426, place,
                      block::toString(*block::elementaryType(syntax.code)));  // S7-TYPES-22
      return block::elementaryType(syntax.code);
    }
    case TypeSyntax::Kind::String:
      return block::stringType(syntax.length);
    case TypeSyntax::Kind::Array: {
      block::TypePtr element = type(source, *syntax.element, Section::Static);
      std::uint64_t count = 1;
      for (const block::Dimension& dimension : syntax.dimensions) count *= dimension.count();
      if (count * std::max(1u, block::sizeInBits(*element)) / 8 > 65'536) {
        problems_.add(ProblemCode::P0427, place, count);
        return block::elementaryType(TypeCode::Bool);
      }
      return block::arrayType(syntax.dimensions, std::move(element));
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
      problems_.add(symbol ? ProblemCode::P0304 : ProblemCode::P0303, place, syntax.symbol);
      return block::elementaryType(TypeCode::Bool);
    }
  }
  return block::elementaryType(TypeCode::Bool);
}

block::TypePtr Interfaces::blockType(const BlockSource& source, const TypeSyntax& syntax,
                                     BlockId id, Section section) {
  const Position place = at(source, syntax.begin, syntax.end);
  if (id.kind == BlockKind::UDT) {
    const block::Block* udt = find(id);
    if (udt && !udt->variables.empty()) return udt->variables.front().type;
    if (!udt) problems_.add(ProblemCode::P0428, place, toString(id));
    return block::elementaryType(TypeCode::Bool);
  }
  // S7-PAR-10: instances only as static variables of an FB.
  const bool instance = (id.kind == BlockKind::FB || id.kind == BlockKind::SFB);
  if (!instance || section != Section::Static ||
      (source.id.kind != BlockKind::FB && source.id.kind != BlockKind::SFB)) {
    problems_.add(ProblemCode::P0429, place, toString(id));
    return block::elementaryType(TypeCode::Bool);
  }
  if (block::TypePtr result = instanceType(id)) return result;
  problems_.add(ProblemCode::P0428, place, toString(id));
  return block::elementaryType(TypeCode::Bool);
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
  if (source.returnType && source.returnType->code != TypeCode::Void) {
    result.returnType = type(source, *source.returnType, Section::Input);
    block::Variable value;
    value.name = "RET_VAL";
    value.section = Section::Return;
    value.type = result.returnType;
    const auto firstTemp =
        std::find_if(result.variables.begin(), result.variables.end(),
                     [](const block::Variable& v) { return v.section == Section::Temp; });
    result.variables.insert(firstTemp, std::move(value));
  } else if (source.returnType && source.returnType->kind != TypeSyntax::Kind::Elementary) {
    result.returnType = type(source, *source.returnType, Section::Input);
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

void Interfaces::resolveData(BlockSource& source, block::Block& result) {
  result.language = block::Language::Db;
  if (!source.dataType) return;
  const TypeSyntax& syntax = *source.dataType;
  if (result.id.kind == BlockKind::UDT) {
    auto named = std::make_shared<block::Type>(*type(source, syntax, Section::Static));
    named->udt = result.id.number;
    block::Variable whole;
    whole.name = toString(result.id);
    whole.type = std::move(named);
    result.variables.push_back(std::move(whole));
    return;
  }
  BlockId instance = syntax.block;
  bool byBlock = syntax.kind == TypeSyntax::Kind::Block;
  if (syntax.kind == TypeSyntax::Kind::Symbol && options_.symbols)
    if (const source::Symbol* symbol = options_.symbols->find(syntax.symbol);
        symbol && symbol->address.kind == source::SymbolAddress::Kind::Block) {
      instance = symbol->address.block;
      byBlock = true;
    }
  if (byBlock && instance.kind != BlockKind::UDT) {
    const block::TypePtr type = instanceType(instance);
    if (!type) {
      problems_.add(ProblemCode::P0428, at(source, syntax.begin, syntax.end), toString(instance));
      return;
    }
    result.instanceOf = instance.number;
    result.instanceOfSystemBlock = instance.kind == BlockKind::SFB;
    dataBlockOf(source, *type, result);
  } else if (syntax.kind == TypeSyntax::Kind::Struct || byBlock ||
             syntax.kind == TypeSyntax::Kind::Symbol) {
    dataBlockOf(source, *type(source, syntax, Section::Static), result);
  } else {
    problems_.add(ProblemCode::P0411, at(source, syntax.begin, syntax.end), toString(result.id));
  }
}

void Interfaces::dataBlockOf(BlockSource& source, const block::Type& type, block::Block& result) {
  result.variables = type.members;
  result.initialData.assign(block::sizeInBytes(type), 0);
  for (const block::Variable& member : type.members)
    block::writeInitial(member, member.address, result.initialData);
  result.actualData = result.initialData;
  if (result.actualData.size() > options_.model->dataBlockSize)  // S7-CPU-08
    problems_.add(ProblemCode::P0503, at(source, source.name.begin, source.name.end),
                  toString(source.id), result.actualData.size(), options_.model->dataBlockSize);
  assignments(source, type.members, result);
}

// BEGIN name[1].x := value ; … : actual values (S7-SRC-08).
void Interfaces::assignments(BlockSource& source, const std::vector<block::Variable>& variables,
                             block::Block& result) {
  Cursor cursor(source.file->text(), source.codeBegin, source.codeEnd);
  for (;;) {
    cursor.skipSpace();
    if (cursor.atEnd()) return;
    if (cursor.accept(';')) continue;
    const std::size_t begin = cursor.pos();
    const auto skip = [&] {
      while (!cursor.atStatementEnd()) cursor.take();
    };
    cursor.accept('#');
    const bool quoted = cursor.accept('"');
    const std::size_t nameBegin = cursor.pos();
    if (quoted)
      while (!cursor.atStatementEnd() && cursor.peek() != '"') cursor.take();
    const std::string_view name = quoted ? cursor.slice(nameBegin, cursor.pos()) : cursor.word();
    if (quoted) cursor.accept('"');
    const block::Variable* variable = findMember(variables, name);
    if (!variable) {
      if (name.empty()) cursor.take();
      problems_.add(ProblemCode::P0420, at(source, begin, cursor.pos()), std::string(name),
                    toString(result.id));
      skip();
      continue;
    }
    Place place{variable->type, variable->address};
    if (!followPath(cursor, place, *source.file, problems_)) {
      skip();
      continue;
    }
    cursor.skipBlanks();
    if (!cursor.accept(':') || !cursor.accept('=')) {
      problems_.add(ProblemCode::P0301, at(source, cursor.pos(), cursor.pos() + 1), ":=");
      skip();
      continue;
    }
    cursor.skipSpace();
    const std::size_t valueBegin = cursor.pos();
    while (!cursor.atStatementEnd()) {
      if (cursor.peek() == '\'')
        cursor.passText();
      else
        cursor.take();
    }
    if (block::isStoredAsPointer(*variable)) {  // a POINTER that the call sets
      problems_.add(ProblemCode::P0424, at(source, begin, cursor.pos()), std::string(name));
      continue;
    }
    const auto bytes = readInitialValue(*place.type, *source.file, valueBegin, cursor.pos(),
                                        source.mnemonics, problems_);
    if (!bytes) continue;
    if (place.type->code == TypeCode::Bool)
      storeElementary(result.actualData, place.address, TypeCode::Bool, bytes->front() & 1u);
    else
      std::copy(bytes->begin(), bytes->end(), result.actualData.begin() + place.address / 8);
  }
}

}  // namespace merker::step7
