#include "graph7/source_call.h"

#include <unordered_map>

#include "base/text.h"

namespace merker::graph7 {
namespace {

using block::Section;

// FB 1, "Motor", #instance. Null if nobody knows the block.
const block::Block* calledBlock(step7::Cursor& cursor, const SourceOperands& operands) {
  const step7::Scope& scope = operands.scope();
  const std::size_t begin = cursor.pos();
  cursor.accept('#');
  const block::Variable* variable = scope.findVariable(cursor.word());
  const TypeCode code = variable == nullptr ? TypeCode::Void : variable->type->code;
  const bool own = code == TypeCode::FunctionBlock;
  if (own || code == TypeCode::SystemFunctionBlock)
    return scope.findBlock({own ? BlockKind::FB : BlockKind::SFB, variable->type->length});
  cursor.seek(begin);
  const auto access = operands.parse(cursor);
  if (!access || access->kind != step7::Access::Kind::BlockName) return nullptr;
  return scope.findBlock(
      {access->operand.blockKind, static_cast<std::uint16_t>(access->operand.value)});
}

graph::Argument unsupplied(const block::Variable& formal) {
  graph::Argument argument;
  argument.name = formal.name;
  argument.output = formal.section == Section::Output || formal.section == Section::Return;
  argument.bit = formal.section == Section::Input && formal.type->code == TypeCode::Bool;
  return argument;
}

std::vector<graph::Argument> parametersOf(const block::Block* callee) {
  std::vector<graph::Argument> out;
  if (callee == nullptr) return out;
  const bool function = callee->id.kind == BlockKind::FC || callee->id.kind == BlockKind::SFC;
  if (function) {
    for (const block::Variable* v : block::parameters(*callee)) out.push_back(unsupplied(*v));
  } else {
    for (const block::Variable& v : callee->variables)
      if (v.section != Section::Static && v.section != Section::Temp) out.push_back(unsupplied(v));
  }
  return out;
}

// The parameters of a CALL in the order of the declaration, also those that the list leaves out;
// behind them what its block does not have.
class Arguments {
 public:
  explicit Arguments(const block::Block* callee) : all_(parametersOf(callee)) {
    for (std::size_t i = 0; i < all_.size(); ++i) numbers_.try_emplace(upper(all_[i].name), i);
  }

  void give(std::string_view name, std::string text, std::int64_t wire) {
    const auto [at, added] = numbers_.try_emplace(upper(name), all_.size());
    if (added) all_.emplace_back();
    graph::Argument& argument = all_[at->second];
    argument.name = name;
    argument.text = std::move(text);
    argument.wire = wire;
  }

  std::vector<graph::Argument> all() { return std::move(all_); }

 private:
  std::vector<graph::Argument> all_;
  std::unordered_map<std::string, std::size_t> numbers_;  // by name
};

// Reads the list behind the name of the block.
class List {
 public:
  List(step7::Cursor& cursor, const SourceOperands& operands, Arguments& out)
      : cursor_(cursor), operands_(operands), out_(out) {}

  void read() {
    const bool bracketed = acceptBracket();
    if (!bracketed && !(cursor_.atLineEnd() && atParameter())) return;
    for (;;) {
      cursor_.skipSpace();
      if (cursor_.accept(',')) continue;
      if (bracketed && cursor_.accept(')')) return;
      if (cursor_.atEnd() || cursor_.peek() == ';' || !parameter()) return;
      cursor_.accept(',');
      if (!bracketed && !(cursor_.atLineEnd() && atParameter())) return;
    }
  }

 private:
  // Behind the name or on the next line.
  bool acceptBracket() {
    if (cursor_.accept('(')) return true;
    const std::size_t begin = cursor_.pos();
    cursor_.skipSpace();
    if (cursor_.accept('(')) return true;
    cursor_.seek(begin);
    return false;
  }

  std::string_view name() {
    cursor_.accept('#');
    const bool quoted = cursor_.accept('"');
    const std::string_view word = cursor_.word();
    if (quoted) cursor_.accept('"');
    cursor_.skipBlanks();
    return cursor_.peek() == ':' && cursor_.peek(1) == '=' ? word : std::string_view();
  }

  bool atParameter() {
    const std::size_t begin = cursor_.pos();
    cursor_.skipSpace();
    const bool found = !name().empty();
    cursor_.seek(begin);
    return found;
  }

  bool parameter() {
    const std::string_view word = name();
    if (word.empty()) return false;
    cursor_.seek(cursor_.pos() + 2);
    cursor_.skipBlanks();
    const std::size_t begin = cursor_.pos();
    actual();
    std::string text(trim(cursor_.slice(begin, cursor_.pos())));
    out_.give(word, std::move(text), wireOf(begin));
    return true;
  }

  void actual() {
    int depth = 0;
    while (!cursor_.atStatementEnd()) {
      const char c = cursor_.peek();
      if (depth == 0 && (c == ',' || c == ')')) return;
      if (c == '\'') {
        cursor_.passText();
        continue;
      }
      cursor_.take();
      if (c == '"')
        while (!cursor_.atStatementEnd() && cursor_.take() != '"') continue;
      depth += c == '(' || c == '[' ? 1 : c == ')' || c == ']' ? -1 : 0;
    }
  }

  std::int64_t wireOf(std::size_t begin) {
    const std::size_t end = cursor_.pos();
    cursor_.seek(begin);
    const bool local = cursor_.peek() == 'L' || cursor_.peek() == 'l';
    const auto access = local ? operands_.parse(cursor_) : std::nullopt;
    cursor_.seek(end);
    const bool wire = access && access->openDb < 0 && access->variable == nullptr &&
                      operands_.isWire(access->operand);
    return wire ? std::int64_t{access->operand.value} : -1;
  }

  step7::Cursor& cursor_;
  const SourceOperands& operands_;
  Arguments& out_;
};

// What is between the word CALL and the list.
std::string_view head(step7::Cursor& cursor) {
  const std::size_t begin = cursor.pos();
  while (!cursor.atStatementEnd() && cursor.peek() != '(')
    if (cursor.take() == '"')
      while (!cursor.atStatementEnd() && cursor.take() != '"') continue;
  return trim(cursor.slice(begin, cursor.pos()));
}

}  // namespace

void readCall(step7::Cursor& cursor, const SourceOperands& operands, bool complete,
              graph::Statement& statement) {
  cursor.skipSpace();
  const std::size_t begin = cursor.pos();
  const block::Block* callee = complete ? calledBlock(cursor, operands) : nullptr;
  cursor.seek(begin);
  graph::Operand& operand = statement.operand;
  operand.text = head(cursor);
  Arguments arguments(callee);
  List(cursor, operands, arguments).read();
  statement.op = graph::Op::CALL;
  statement.arguments = arguments.all();
  operand.kind = graph::OperandKind::Number;
  operand.code = normalized(operand.text);
  for (const graph::Argument& argument : statement.arguments)
    operand.code += " " + upper(argument.name) + "=" + normalized(argument.text);
}

std::vector<graph::Argument> parametersOf(std::string_view text, const SourceOperands& operands) {
  step7::Cursor cursor(text, 0, text.size());
  return parametersOf(calledBlock(cursor, operands));
}

}  // namespace merker::graph7
