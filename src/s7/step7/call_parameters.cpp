#include "step7/call_parameters.h"

#include "base/text.h"
#include "step7/declaration.h"
#include "step7/initial_value.h"
#include "step7/pointer_value.h"

namespace merker::step7 {

using block::Section;
using mc7::OperandKind;

std::optional<Actuals> CallParameters::read() {
  Cursor& cursor = c_.cursor();
  const std::size_t begin = cursor.pos();
  bool good = true;
  if (cursor.atLineEnd() && atParameterLine()) {
    good = body(false);
  } else if (acceptBracket()) {
    good = body(true);
  }
  if (!good || !complete(begin)) return std::nullopt;
  return std::move(actuals_);
}

void CallParameters::skip() {
  Cursor& cursor = c_.cursor();
  while (!cursor.atStatementEnd() && cursor.peek() != '(') cursor.take();
  if (!acceptBracket()) return;
  for (int depth = 1; depth > 0;) {
    cursor.skipSpace();
    if (cursor.atEnd() || cursor.peek() == ';') return;
    if (cursor.peek() == '\'') {
      cursor.passText();
      continue;
    }
    const char c = cursor.take();
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
  }
}

bool CallParameters::ofAnotherBlock() {
  const block::Program* library = c_.scope().options->library;
  const auto found = library ? library->find(target_.id) : block::Program::const_iterator{};
  const bool system = target_.id.kind == BlockKind::SFC || target_.id.kind == BlockKind::SFB;
  if (system || !library || found == library->end() || &found->second != target_.block)
    return false;
  Cursor& cursor = c_.cursor();
  const std::size_t start = cursor.pos();
  const std::size_t comments = cursor.checks().size();
  const bool other = acceptBracket() && noneKnown();
  cursor.seek(start);
  cursor.checks().resize(comments);
  return other;
}

// Looks at all "name :=" up to the closing bracket; at least one must be there.
bool CallParameters::noneKnown() {
  Cursor& cursor = c_.cursor();
  bool any = false;
  for (int depth = 1; depth > 0;) {
    cursor.skipSpace();
    if (cursor.atEnd() || cursor.peek() == ';') break;
    const std::string_view name = cursor.word();
    if (!name.empty()) {
      cursor.skipBlanks();
      if (cursor.peek() != ':' || cursor.peek(1) != '=') continue;
      if (formal(name)) return false;
      any = true;
    } else if (cursor.peek() == '\'') {
      cursor.passText();
    } else {
      const char c = cursor.take();
      depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    }
  }
  return any;
}

const block::Variable* CallParameters::formal(std::string_view name) const {
  const block::Variable* found = c_.scope().interfaces->names(*target_.block).find(name);
  const bool parameter =
      found && found->section != Section::Static && found->section != Section::Temp;
  return parameter ? found : nullptr;
}

// The bracket of the parameter list stands behind the block's name or on the next line; no
// instruction begins with it.
bool CallParameters::acceptBracket() {
  Cursor& cursor = c_.cursor();
  if (cursor.accept('(')) return true;
  const std::size_t start = cursor.pos();
  const std::size_t comments = cursor.checks().size();
  cursor.skipSpace();
  if (cursor.accept('(')) return true;
  cursor.seek(start);
  cursor.checks().resize(comments);
  return false;
}

// Whether the next line that is not empty begins with "name :=".
bool CallParameters::atParameterLine() {
  Cursor& cursor = c_.cursor();
  const std::size_t start = cursor.pos();
  const std::size_t comments = cursor.checks().size();
  cursor.skipSpace();
  const bool quoted = cursor.accept('"');
  const bool word = !cursor.word().empty();
  if (quoted) cursor.accept('"');
  cursor.skipBlanks();
  const bool found = word && cursor.peek() == ':' && cursor.peek(1) == '=';
  cursor.seek(start);
  cursor.checks().resize(comments);
  return found;
}

// On to the next parameter: behind the comma, or to the end of the line or list.
void CallParameters::skipParameter() {
  Cursor& cursor = c_.cursor();
  int depth = 0;
  while (!cursor.atStatementEnd()) {
    const char c = cursor.peek();
    if (depth == 0 && (c == ',' || c == ')')) return;
    depth += c == '(' || c == '[' ? 1 : c == ')' || c == ']' ? -1 : 0;
    cursor.take();
  }
}

bool CallParameters::body(bool bracketed) {
  Cursor& cursor = c_.cursor();
  bool good = true;
  for (;;) {
    cursor.skipSpace();
    if (cursor.accept(',')) continue;
    if (bracketed && cursor.peek() == ')') {
      cursor.take();
      return good;
    }
    if (cursor.atEnd() || cursor.peek() == ';')
      return bracketed ? problem(ProblemCode::P0301, cursor.pos(), cursor.pos() + 1, ")") : good;
    if (!parameter()) {
      good = false;
      skipParameter();
    }
    cursor.skipBlanks();
    cursor.accept(',');
    if (!bracketed && !(cursor.atLineEnd() && atParameterLine())) return good;
  }
}

bool CallParameters::parameter() {
  Cursor& cursor = c_.cursor();
  cursor.accept('#');
  const std::size_t begin = cursor.pos();
  const bool quoted = cursor.accept('"');
  std::string name(cursor.word());
  if (quoted) cursor.accept('"');
  const block::Variable* const formal = this->formal(name);
  if (name.empty() || !formal)
    return problem(ProblemCode::P0511, begin, std::max(cursor.pos(), begin + 1), name,
                   target_.name());
  cursor.skipSpace();
  if (!cursor.accept(':') || !cursor.accept('='))
    return problem(ProblemCode::P0301, cursor.pos(), cursor.pos() + 1, ":=");
  if (actuals_.count(formal)) return problem(ProblemCode::P0513, begin, cursor.pos(), name);
  cursor.skipBlanks();
  // "name :=" alone: not supplied.
  if (cursor.atStatementEnd() || cursor.peek() == ',' || cursor.peek() == ')') return true;
  Actual value;
  if (!actual(value)) return false;
  if (formal->type->code == TypeCode::Void)
    return problem(ProblemCode::P0430, begin, cursor.pos(), name);
  if (!check(*formal, value)) return false;
  actuals_.emplace(formal, std::move(value));
  return true;
}

bool CallParameters::actual(Actual& out) {
  Cursor& cursor = c_.cursor();
  out.begin = cursor.pos();
  const bool p = cursor.peek() == 'P' || cursor.peek() == 'p';
  if (p && cursor.peek(1) == '#' && cursor.peek(2) != '#') {
    if (!pointer(out)) return false;
  } else if (cursor.acceptWord("NIL")) {
    out.nil = true;
  } else {
    out.access = c_.operand();
    if (!out.access) return false;
  }
  out.end = cursor.pos();
  return true;
}

bool CallParameters::pointer(Actual& out) {
  const auto value = readPointer(c_.cursor(), *c_.scope().file, c_.problems());
  if (!value) return false;
  out.isPointer = true;
  out.nil = value->type == TypeCode::Void;  // P#P 0.0 VOID 0
  out.db = value->db;
  out.pointer = value->pointer;
  if (pointerArea(out.pointer) == Area::Local)  // the called block sees it as the caller's
    out.pointer = merker::pointer(Area::CallerLocal, pointerAddress(out.pointer));
  out.anyType = value->type.value_or(TypeCode::Void);
  out.anyCount = value->count;
  return true;
}

bool CallParameters::mismatch(const block::Variable& formal, const Actual& actual) {
  const std::string_view text = c_.cursor().slice(actual.begin, actual.end);
  return problem(ProblemCode::P0514, actual.begin, actual.end, std::string(text),
                 block::toString(*formal.type), formal.name);
}

bool CallParameters::check(const block::Variable& formal, Actual& actual) {
  const TypeCode code = formal.type->code;
  if (!checkForwarding(formal, actual)) return false;
  if (isParameterNumber(code)) return checkNumber(formal, actual);
  if (code == TypeCode::Any || code == TypeCode::Pointer) {
    if (code == TypeCode::Pointer && (actual.nil || actual.anyType != TypeCode::Void))
      return mismatch(formal, actual);
    if (actual.isConstant()) return mismatch(formal, actual);
    return true;
  }
  if (actual.isPointer && code == TypeCode::DWord && actual.anyType == TypeCode::Void &&
      actual.db == 0) {
    Access constant;
    constant.operand = mc7::constant(ConstantFormat::Pointer, actual.pointer);
    actual.access = constant;
    actual.isPointer = false;
  }
  if (actual.nil || actual.isPointer) return mismatch(formal, actual);
  if (actual.access->kind == Access::Kind::BlockName ||
      actual.access->kind == Access::Kind::Address)
    return mismatch(formal, actual);
  return isElementary(code) ? checkElementary(formal, actual) : checkComposite(formal, actual);
}

bool CallParameters::checkConstant(const block::Variable& formal, Actual& actual) {
  if (formal.section != Section::Input)  // something has to be written to it
    return problem(ProblemCode::P0512, actual.begin, actual.end, formal.name);
  mc7::Operand& operand = actual.access->operand;
  const auto bits = convertConstant({operand.format, operand.value}, formal.type->code);
  if (!bits) return mismatch(formal, actual);
  operand.value = *bits;
  return true;
}

bool CallParameters::checkElementary(const block::Variable& formal, Actual& actual) {
  if (actual.isConstant()) return checkConstant(formal, actual);
  const Access& access = *actual.access;
  const mc7::Operand& operand = access.operand;
  const bool direct = operand.kind == OperandKind::Memory || access.variable ||
                      access.kind == Access::Kind::Descriptor;
  if (!direct)
    return problem(ProblemCode::P0515, actual.begin, actual.end,
                   c_.cursor().slice(actual.begin, actual.end), formal.name,
                   block::toString(*formal.type));
  if (operand.area == Area::Peripheral &&
      access.peripheralOutput != (formal.section != Section::Input))
    return problem(access.peripheralOutput ? ProblemCode::P0324 : ProblemCode::P0323, actual.begin,
                   actual.end);
  if (operand.width != widthOf(formal.type->code)) return mismatch(formal, actual);
  // A declared variable must have the very type, an absolute operand fits every type of its width
  // (S7-PAR-05).
  if (access.type && access.type->code != formal.type->code) return mismatch(formal, actual);
  return true;
}

bool CallParameters::checkComposite(const block::Variable& formal, const Actual& actual) {
  const block::TypePtr& type = actual.access->type;
  if (!type) return mismatch(formal, actual);  // S7-PAR-04: only variables
  if (formal.type->code == TypeCode::String && type->code == TypeCode::String) {
    const bool byValue = !target_.isFunction() && formal.section != Section::InOut;
    return !byValue || formal.type->length == type->length || mismatch(formal, actual);
  }
  return c_.scope().interfaces->structures().same(formal.type, type) || mismatch(formal, actual);
}

bool CallParameters::checkNumber(const block::Variable& formal, const Actual& actual) {
  if (!actual.access) return mismatch(formal, actual);
  const mc7::Operand& operand = actual.access->operand;
  const TypeCode code = formal.type->code;
  if (actual.access->variable)
    return (actual.access->variable->type->code == code) || mismatch(formal, actual);
  const bool block = operand.kind == OperandKind::Block && operand.reg == 0;
  const bool fits = code == TypeCode::Timer     ? operand.kind == OperandKind::Timer
                    : code == TypeCode::Counter ? operand.kind == OperandKind::Counter
                    : code == TypeCode::BlockFc ? block && operand.blockKind == BlockKind::FC
                    : code == TypeCode::BlockFb ? block && operand.blockKind == BlockKind::FB
                    : code == TypeCode::BlockDb ? block && operand.blockKind == BlockKind::DB
                                                : block && operand.blockKind == BlockKind::SDB;
  return fits || mismatch(formal, actual);
}

// What a block may hand on of its own parameters (S7-PAR-06).
bool CallParameters::checkForwarding(const block::Variable& formal, const Actual& actual) {
  if (!actual.access || !actual.access->variable) return true;
  const block::Variable& own = *actual.access->variable;
  if (own.section == Section::Temp || own.section == Section::Static) return true;
  const auto forbidden = [&] {
    return problem(ProblemCode::P0516, actual.begin, actual.end, own.name, formal.name);
  };
  const bool writes = formal.section != Section::Input;
  if (writes && own.section == Section::Input && isElementary(formal.type->code))
    return forbidden();
  const bool ownFunction = c_.scope().block->id.kind == BlockKind::FC;
  const TypeCode code = own.type->code;
  const bool onlyWritten = own.section == Section::Output || own.section == Section::Return;
  if (ownFunction && onlyWritten && formal.section != Section::Output &&
      formal.section != Section::Return)
    return forbidden();
  if (ownFunction && target_.isFunction() && !isElementary(code)) {
    // One element of a composite parameter is an elementary value.
    const bool element = actual.access->kind == Access::Kind::Descriptor && actual.access->type &&
                         isElementary(actual.access->type->code);
    if (!element) return forbidden();
  }
  if (target_.isFunction() && isParameterNumber(code)) return forbidden();
  return true;
}

bool CallParameters::complete(std::size_t begin) {
  if (!target_.isFunction()) return true;
  constexpr int kTold = 20;  // of a call; a block may have thousands, and a source such calls
  int missing = 0;
  for (const block::Variable* formal : c_.scope().interfaces->names(*target_.block).parameters())
    if (!actuals_.count(formal) && ++missing <= kTold)  // S7-BLK-18
      (void)problem(ProblemCode::P0517, begin, begin + 1, formal->name, target_.name());
    else if (missing > kTold)
      break;
  return missing == 0;
}

}  // namespace merker::step7
