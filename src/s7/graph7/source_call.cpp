#include "graph7/source_call.h"

#include <algorithm>

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

const block::Variable* formal(const block::Block* callee, std::string_view name) {
  if (callee == nullptr) return nullptr;
  for (const block::Variable& v : callee->variables)
    if (equalsIgnoreCase(v.name, name)) return &v;
  return nullptr;
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

// Reads the list behind the name of the block.
class List {
 public:
  List(step7::Cursor& cursor, const SourceOperands& operands, const block::Block* callee,
       std::vector<graph::Argument>& out)
      : cursor_(cursor), operands_(operands), callee_(callee), out_(out) {}

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
    graph::Argument argument;
    if (const block::Variable* declared = formal(callee_, word)) argument = unsupplied(*declared);
    argument.name = word;
    const std::size_t begin = cursor_.pos();
    actual();
    argument.text = trim(cursor_.slice(begin, cursor_.pos()));
    argument.wire = wireOf(begin);
    out_.push_back(std::move(argument));
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
  const block::Block* callee_;
  std::vector<graph::Argument>& out_;
};

// In the order of the declaration, with those that the list leaves out.
std::vector<graph::Argument> completed(std::vector<graph::Argument> given,
                                       const block::Block* callee) {
  std::vector<graph::Argument> out = parametersOf(callee);
  for (graph::Argument& argument : given) {
    const auto at = std::find_if(out.begin(), out.end(), [&](const graph::Argument& parameter) {
      return equalsIgnoreCase(parameter.name, argument.name);
    });
    if (at == out.end())
      out.push_back(std::move(argument));
    else
      *at = std::move(argument);
  }
  return out;
}

// What is between the word CALL and the list.
std::string_view head(step7::Cursor& cursor) {
  const std::size_t begin = cursor.pos();
  while (!cursor.atStatementEnd() && cursor.peek() != '(')
    if (cursor.take() == '"')
      while (!cursor.atStatementEnd() && cursor.take() != '"') continue;
  return trim(cursor.slice(begin, cursor.pos()));
}

}  // namespace

void readCall(step7::Cursor& cursor, const SourceOperands& operands, graph::Statement& statement) {
  cursor.skipSpace();
  const std::size_t begin = cursor.pos();
  const block::Block* callee = calledBlock(cursor, operands);
  cursor.seek(begin);
  graph::Operand& operand = statement.operand;
  operand.text = head(cursor);
  std::vector<graph::Argument> given;
  List(cursor, operands, callee, given).read();
  statement.op = graph::Op::CALL;
  statement.arguments = completed(std::move(given), callee);
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
