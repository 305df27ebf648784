#include "step7/path.h"

#include "base/text.h"
#include "step7/declaration.h"

namespace merker::step7 {

const block::Variable* findMember(const std::vector<block::Variable>& members,
                                  std::string_view name) {
  for (const block::Variable& member : members)
    if (equalsIgnoreCase(member.name, name)) return &member;
  return nullptr;
}

namespace {

// #text[3] is the third character of a STRING; two length bytes stand before the first.
bool followCharacter(Cursor& cursor, Place& place, const source::SourceFile& file,
                     Problems& problems) {
  const std::size_t open = cursor.pos();
  cursor.take();
  const auto index = readInteger(cursor);
  const bool closed = cursor.accept(']');
  const auto here = file.position(open, std::max(cursor.pos(), open + 1) - open);
  if (!index || !closed) {
    problems.add(index ? ProblemCode::P0417 : ProblemCode::P0418, here, 1);
    return false;
  }
  if (*index < 1 || *index > place.type->length) {
    problems.add(ProblemCode::P0419, here, *index, 1, place.type->length);
    return false;
  }
  place.address += bitAddress(static_cast<std::uint32_t>(*index) + 1);
  place.type = block::elementaryType(TypeCode::Char);
  return true;
}

bool followIndex(Cursor& cursor, Place& place, const source::SourceFile& file, Problems& problems) {
  if (place.type->code == TypeCode::String) return followCharacter(cursor, place, file, problems);
  const std::size_t open = cursor.pos();
  cursor.take();
  const auto here = [&] { return file.position(open, std::max(cursor.pos(), open + 1) - open); };
  const block::Type& array = *place.type;
  if (array.code != TypeCode::Array) {
    problems.add(ProblemCode::P0416, here(), block::toString(array));
    return false;
  }
  std::vector<std::int32_t> indices;
  do {
    const auto index = readInteger(cursor);
    if (!index || indices.size() >= array.dimensions.size()) {
      problems.add(index ? ProblemCode::P0417 : ProblemCode::P0418, here(),
                   array.dimensions.size());
      return false;
    }
    const block::Dimension& range = array.dimensions[indices.size()];
    if (*index < range.low || *index > range.high) {
      problems.add(ProblemCode::P0419, here(), *index, range.low, range.high);
      return false;
    }
    indices.push_back(static_cast<std::int32_t>(*index));
  } while (cursor.accept(','));
  if (!cursor.accept(']') || indices.size() != array.dimensions.size()) {
    problems.add(ProblemCode::P0417, here(), array.dimensions.size());
    return false;
  }
  place.address += block::elementOffset(array, indices);
  place.type = array.element;
  return true;
}

bool followMember(Cursor& cursor, Place& place, const source::SourceFile& file, Problems& problems,
                  MemberIndex* index) {
  cursor.take();
  cursor.skipBlanks();
  const std::size_t begin = cursor.pos();
  std::string_view name;
  if (cursor.accept('"')) {
    while (!cursor.atEnd() && cursor.peek() != '"' && cursor.peek() != '\n') cursor.take();
    name = cursor.slice(begin + 1, cursor.pos());
    cursor.accept('"');
  } else {
    name = cursor.word();
  }
  const auto& members = place.type->members;
  const block::Variable* member = index ? index->find(members, name) : findMember(members, name);
  if (!member) {
    problems.add(ProblemCode::P0420,
                 file.position(begin, std::max(cursor.pos(), begin + 1) - begin), std::string(name),
                 block::toString(*place.type));
    return false;
  }
  place.address += member->address;
  place.type = member->type;
  return true;
}

}  // namespace

bool followPath(Cursor& cursor, Place& place, const source::SourceFile& file, Problems& problems,
                MemberIndex* index) {
  for (;;) {
    const std::size_t before = cursor.pos();
    if (place.type->code == TypeCode::Void) {
      problems.add(ProblemCode::P0430, file.position(before), "a variable of unknown type");
      return false;
    }
    cursor.skipBlanks();
    if (cursor.peek() == '[') {
      if (!followIndex(cursor, place, file, problems)) return false;
    } else if (cursor.peek() == '.' &&
               (isWordStart(cursor.peek(1)) || cursor.peek(1) == '"' || cursor.peek(1) == ' ')) {
      if (!followMember(cursor, place, file, problems, index)) return false;
    } else {
      cursor.seek(before);
      return true;
    }
  }
}

}  // namespace merker::step7
