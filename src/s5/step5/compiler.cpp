#include "step5/compiler.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <list>

#include "mc5/resident_blocks.h"
#include "step5/block_source.h"
#include "step5/code_block.h"
#include "step5/comment.h"
#include "step5/data_block.h"
#include "step5/declaration.h"
#include "step5/line_end.h"
#include "step5/statement.h"

namespace merker::step5 {
namespace {

using mc5::BlockType;

// DBs of the system (S5-DB-10, OP-01).
constexpr std::array<std::uint16_t, 6> kSystemDbs{1, 36, 37, 39, 40, 71};

struct Unit {
  BlockSource source;
  mc5::Block block;
  std::size_t firstLine = 0;  // behind the declaration
  std::string nameLine;
  Problems problems;
};

Unit begin(BlockSource source, const Problems& all) {
  Unit unit;
  unit.problems = Problems(all.stop());
  unit.source = std::move(source);
  unit.block.id = unit.source.id;
  unit.block.library = unit.source.library;
  unit.block.file = unit.source.file->name();
  unit.block.heading = unit.source.heading;
  keepComment(unit.block, 0, false, unit.source.comment);
  if (unit.source.id.type != BlockType::Fb) return unit;
  Declaration declaration = readDeclaration(unit.source, unit.problems);
  unit.block.name = std::move(declaration.name);
  unit.block.parameters = std::move(declaration.parameters);
  unit.firstLine = declaration.lines;
  for (const std::string& comment : declaration.comments)
    keepComment(unit.block, 0, false, comment);
  unit.nameLine = std::move(declaration.nameLine);
  return unit;
}

Position headOf(const Unit& unit) {
  return unit.source.file->position(unit.source.offset, unit.source.length);
}

void checkNumber(Unit& unit) {
  const mc5::BlockId id = unit.block.id;
  if (id.type == BlockType::Fb && mc5::findResident(id.number) != nullptr)
    unit.problems.add(ProblemCode::P1127, headOf(unit), id.number);
  const bool system =
      std::find(kSystemDbs.begin(), kSystemDbs.end(), id.number) != kSystemDbs.end();
  if (id.type == BlockType::Db && system)
    unit.problems.add(ProblemCode::P1134, headOf(unit), id.number);
}

// The first block of a number stays; the others are told where it is.
void checkTwice(std::list<Unit>& units) {
  std::map<mc5::BlockId, const Unit*> seen;
  for (Unit& unit : units) {
    const auto [found, fresh] = seen.emplace(unit.block.id, &unit);
    if (fresh) continue;
    const Position first = headOf(*found->second);
    unit.problems.add(ProblemCode::P1120, headOf(unit), toString(unit.block.id),
                      fmt::format("{}:{}", first.file, first.line));
  }
}

Callable callable(const std::list<Unit>& units) {
  Callable known;
  for (const mc5::Block& block : mc5::residentBlocks())
    known.functionBlocks[block.id.number] = &block;
  for (const Unit& unit : units) {
    known.blocks.insert(unit.block.id);
    if (unit.block.id.type != BlockType::Fb) continue;
    known.names.emplace(unit.block.id.number, unit.nameLine);
    known.functionBlocks.emplace(unit.block.id.number,
                                 unit.problems.hasErrors() ? nullptr : &unit.block);
  }
  return known;
}

void finish(Unit& unit, const Callable& known, bool checks, Compilation& result) {
  if (result.problems.cancelled()) return;
  if (unit.block.id.type == BlockType::Db)
    compileData(unit.source, unit.block, unit.problems);
  else
    compileCode(unit.source, unit.firstLine, known, checks, unit.block, unit.problems);
  result.problems.append(unit.problems);
  if (!unit.problems.hasErrors()) result.program.emplace(unit.block.id, unit.block);
}

}  // namespace

Compilation compile(const std::vector<source::SourceFile>& sources, bool checks,
                    std::stop_token stop, const source::SymbolTable* symbols) {
  Compilation result;
  result.problems = Problems(std::move(stop));
  std::list<Unit> units;  // blocks are referred to while the list grows
  for (const source::SourceFile& file : sources) {
    const std::size_t before = units.size();
    for (BlockSource& source : findBlocks(file, result.problems))
      units.push_back(begin(std::move(source), result.problems));
    if (units.size() == before && !result.problems.hasErrors())
      result.problems.add(ProblemCode::P0104, Position{file.name()});
  }
  Callable known = callable(units);  // before other problems than those of declarations
  known.symbols = symbols;
  checkTwice(units);
  for (Unit& unit : units) checkNumber(unit);
  for (Unit& unit : units) finish(unit, known, checks, result);
  result.problems.sort();
  return result;
}

namespace {

// "SPA 5", "SPB -5": the distance without its sign of equality.
std::string withSign(std::string_view text) {
  std::string result(text);
  const std::size_t word = text.find_first_not_of(" \t:");
  const std::size_t blank = text.find_first_of(" \t", word);
  const std::size_t number = text.find_first_not_of(" \t", blank);
  if (blank == text.npos || number == text.npos || upper(text[word]) != 'S') return result;
  const bool sign = text[number] == '-' || text[number] == '+';
  if (blank - word != 3 || upper(text[word + 1]) != 'P') return result;
  if (!sign && !isDigit(text[number])) return result;
  return result.insert(number, sign ? "=" : "=+");
}

}  // namespace

Result<mc5::Instruction> parseInstruction(std::string_view given, const Position& at) {
  const std::string text = withSign(given);
  Scanner scanner(text, 0);
  scanner.skipBlanks();
  skipColon(scanner);
  Failure failure;
  const auto problem = [&] {
    Position place = at;
    place.column += static_cast<std::uint32_t>(failure.offset);
    place.length = static_cast<std::uint32_t>(failure.length);
    return makeProblem(failure.code, place, failure.what, failure.expected);
  };
  const auto statement = parseStatement(scanner, failure);
  if (!statement || !commentFollows(scanner, failure)) return problem();
  if (statement->name.empty()) return statement->instruction;
  failure = {ProblemCode::P1105, statement->operandOffset, statement->name.size(), "", ""};
  return problem();
}

}  // namespace merker::step5
