#include "step7/compiler.h"

#include <map>

#include "base/text.h"
#include "mc7/place.h"
#include "step7/block_compiler.h"
#include "step7/block_source.h"
#include "step7/foreign_language.h"
#include "step7/interfaces.h"
#include "step7/machine_instruction.h"

namespace merker::step7 {

// What follows from a faulty declaration is told only if nothing else is.
static Problems withoutConsequences(const Problems& problems) {
  Problems causes = problems;
  causes.remove(ProblemCode::P0430);
  return causes.hasErrors() ? causes : problems;
}

namespace {

// What the CPU brings; a source declares its interface only.
bool isSystemBlock(BlockId id) { return id.kind == BlockKind::SFC || id.kind == BlockKind::SFB; }

using Uses = std::map<const source::SourceFile*, MnemonicUse>;

void addUse(MnemonicUse& sum, const MnemonicUse& block) {
  if (!sum.foreign) sum.foreign = block.foreign;
  sum.ambiguous.insert(sum.ambiguous.end(), block.ambiguous.begin(), block.ambiguous.end());
}

// One warning for each source that mixes both mnemonics, and what cannot be understood then.
void reportMixtures(const Uses& uses, const CompileOptions& options, Problems& problems) {
  for (const auto& [file, use] : uses) {
    if (!use.foreign) continue;
    problems.add(*use.foreign);
    if (options.mnemonics) continue;
    for (const Problem& problem : use.ambiguous) problems.add(problem);
  }
}

}  // namespace

Compilation compile(const std::vector<source::SourceFile>& sources, const CompileOptions& options) {
  Compilation result;
  result.problems = Problems(options.stop);
  std::vector<BlockSource> blocks;
  for (const source::SourceFile& file : sources) {
    const std::size_t before = result.problems.size();
    if (const auto foreign = foreignText(file.text(), options.stop)) {
      result.problems.add(ProblemCode::P0334,
                          file.position(foreign->begin, foreign->end - foreign->begin),
                          foreign->refusal);
      continue;
    }
    std::vector<BlockSource> found = BlockSplitter(file, options.symbols, result.problems).split();
    const Mnemonics mnemonics =
        options.mnemonics ? *options.mnemonics : detectMnemonics(file.text(), found);
    for (BlockSource& block : found) {
      block.mnemonics = mnemonics;
      blocks.push_back(std::move(block));
    }
    if (found.empty() && before == result.problems.size())
      result.problems.add(ProblemCode::P0104, Position{file.name(), 0, 0, 0});
  }
  Interfaces interfaces(blocks, options, result.problems);
  interfaces.resolveAll();
  Uses uses;
  for (const BlockSource& source : blocks) {
    const bool code = source.id.kind != BlockKind::DB && source.id.kind != BlockKind::UDT &&
                      !isSystemBlock(source.id);
    const auto target = interfaces.program().find(source.id);
    if (!code || target == interfaces.program().end() || source.duplicate) continue;
    if (result.problems.cancelled()) break;
    BlockCompiler compiler(source, target->second, interfaces, options, result.problems);
    compiler.compile();
    addUse(uses[source.file], compiler.mnemonicUse());
  }
  reportMixtures(uses, options, result.problems);
  result.program = std::move(interfaces.program());
  std::erase_if(result.program, [](const auto& entry) { return isSystemBlock(entry.first); });
  result.problems = withoutConsequences(result.problems);
  result.problems.sort();
  return result;
}

Result<address::Reference> resolve(std::string_view text, const block::Program& program,
                                   const CompileOptions& options, const Position& at) {
  const source::SourceFile file(at.file, std::string(text));
  Scope scope;
  scope.file = &file;
  scope.anyMnemonics = true;
  scope.options = &options;
  scope.program = &program;
  Problems problems;
  std::uint32_t localTop = 0;
  Cursor cursor(file.text(), 0, file.text().size());
  const auto access = OperandParser(cursor, scope, problems, localTop).parse();
  const auto place = [&at](Problem problem) {
    problem.position = at;
    return problem;
  };
  if (!access || problems.hasErrors()) return place(problems.list().front());
  cursor.skipSpace();
  const mc7::Operand& operand = access->operand;
  const bool memory = operand.kind == mc7::OperandKind::Memory && operand.area != Area::Local &&
                      operand.area != Area::Instance &&
                      (operand.area != Area::DataBlock || access->openDb >= 0);
  const bool number =
      operand.kind == mc7::OperandKind::Timer || operand.kind == mc7::OperandKind::Counter;
  const TypeCode type = access->type ? access->type->code : TypeCode::Void;
  const bool isLong = memory && (type == TypeCode::DateAndTime || type == TypeCode::String);
  const bool composite = access->type && !isElementary(type) && !isLong;
  if (!cursor.atEnd() || (!memory && !number) || composite)
    return makeProblem(ProblemCode::P0904, at, std::string(text));
  address::Reference reference;
  reference.text = trim(text);
  reference.operand = mc7::placeOf(operand);
  reference.db = access->openDb;
  reference.type = type;
  reference.outputSide = access->peripheralOutput;
  if (isLong) reference.bytes = block::sizeInBytes(*access->type);
  if (const source::Symbol* symbol =
          options.symbols && reference.text.starts_with('"')
              ? options.symbols->find(reference.text.substr(1, reference.text.size() - 2))
              : nullptr)
    reference.type = symbol->type;
  return reference;
}

Result<mc7::Instruction> parseInstruction(std::string_view text, const Position& at,
                                          std::optional<Mnemonics> setting) {
  return parseMachineInstruction(text, at, setting);
}

std::optional<Result<std::uint32_t>> parseListEntry(std::string_view text, const Position& at) {
  return parseMachineEntry(text, at);
}

}  // namespace merker::step7
