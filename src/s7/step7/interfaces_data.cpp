// Data blocks and UDTs: their structure, start values and actual values (S7-SRC-08).
#include <algorithm>

#include "step7/initial_value.h"
#include "step7/interfaces.h"
#include "step7/path.h"

namespace merker::step7 {

using block::Section;

void Interfaces::resolveData(BlockSource& source, block::Block& result) {
  result.language = block::Language::Db;
  if (!source.dataType) return;
  const TypeSyntax& syntax = *source.dataType;
  if (result.id.kind == BlockKind::UDT) {
    const block::TypePtr structure = type(source, syntax, Section::Static);
    if (structure->code == TypeCode::Void) return;
    auto named = std::make_shared<block::Type>(*structure);
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
      missing(source, at(source, syntax.begin, syntax.end), instance);
      return;
    }
    result.instanceOf = instance.number;
    result.instanceOfSystemBlock = instance.kind == BlockKind::SFB;
    dataBlockOf(source, type, result);
  } else if (syntax.kind == TypeSyntax::Kind::Struct || byBlock ||
             syntax.kind == TypeSyntax::Kind::Symbol) {
    const block::TypePtr whole = type(source, syntax, Section::Static);
    if (whole->code != TypeCode::Void) dataBlockOf(source, whole, result);
  } else {
    problems_.add(ProblemCode::P0411, at(source, syntax.begin, syntax.end), toString(result.id));
  }
}

// Of all blocks together; the largest CPU has less work memory. Components: what lies within the
// variables, too, and has to be walked for each block.
constexpr std::uint64_t kMostData = 64 * 1024 * 1024, kMostVariables = 1'000'000;
constexpr std::uint64_t kMostComponents = 10'000'000;
constexpr std::uint32_t kLargestBlock = 0x10000;

void Interfaces::dataBlockOf(BlockSource& source, const block::TypePtr& type,
                             block::Block& result) {
  const Position place = at(source, source.name.begin, source.name.end);
  const std::uint32_t bytes = block::sizeInBytes(*type);
  const std::vector<block::Variable>& members = type->members;
  if (bytes > options_.model->dataBlockSize)  // S7-CPU-08
    problems_.add(ProblemCode::P0503, place, toString(source.id), bytes,
                  options_.model->dataBlockSize);
  if (bytes > kLargestBlock || !take(dataBytes_, bytes, kMostData, "bytes of data", place) ||
      !take(variables_, members.size(), kMostVariables, "variables of data blocks", place) ||
      !take(components_, extent(type).parts, kMostComponents, "components of data blocks", place))
    return;
  result.variables = members;
  result.initialData.assign(bytes, 0);
  for (const block::Variable& member : members)
    block::writeInitial(member, member.address, result.initialData);
  result.actualData = result.initialData;
  assignments(source, members, result);
}

block::TypePtr dataTypeOf(const block::Block& db) {
  auto type = std::make_shared<block::Type>();
  type->code = TypeCode::Struct;
  type->members = db.variables;
  return type;
}

block::TypePtr Interfaces::dataType(const block::Block& db) {
  block::TypePtr& known = dataTypes_[db.id];
  if (!known) known = unknown(db.id) ? block::elementaryType(TypeCode::Void) : dataTypeOf(db);
  return known;
}

// BEGIN name[1].x := value ; … : actual values (S7-SRC-08).
void Interfaces::assignments(BlockSource& source, const std::vector<block::Variable>& variables,
                             block::Block& result) {
  MemberIndex index;
  Cursor cursor(source.file->text(), source.codeBegin, source.codeEnd, problems_.stop());
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
    const block::Variable* variable = index.find(variables, name);
    if (!variable) {
      if (name.empty()) cursor.take();
      problems_.add(ProblemCode::P0420, at(source, begin, cursor.pos()), std::string(name),
                    toString(result.id));
      skip();
      continue;
    }
    Place place{variable->type, variable->address};
    if (!followPath(cursor, place, *source.file, problems_, &index)) {
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
