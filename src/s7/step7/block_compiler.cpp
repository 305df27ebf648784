#include "step7/block_compiler.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/text.h"
#include "step7/call_compiler.h"
#include "step7/check_comment.h"
#include "step7/mnemonic.h"

namespace merker::step7 {

using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

// Of an OB: what the operating system writes to its local data (S7-OBI-01).
constexpr std::uint32_t kStartInformation = 20;

BlockCompiler::BlockCompiler(const BlockSource& source, block::Block& target,
                             Interfaces& interfaces, const CompileOptions& options,
                             Problems& problems)
    : source_(source),
      target_(target),
      options_(options),
      finalProblems_(problems),
      problems_(problems.stop()),
      cursor_(source.file->text(), source.codeBegin, source.codeEnd, problems.stop()) {
  scope_.file = source.file;
  scope_.mnemonics = source.mnemonics;
  scope_.options = &options;
  scope_.interfaces = &interfaces;
  scope_.block = &target;
  scope_.names = &interfaces.names(target);
  scope_.use = &use_;
}

namespace {

// What is not in the program is reported where a block uses it first: a missing data block is one
// problem and not a hundred.
Problems firstUses(const Problems& problems) {
  static constexpr ProblemCode kMissing[] = {ProblemCode::P0303, ProblemCode::P0313,
                                             ProblemCode::P0354, ProblemCode::P0506,
                                             ProblemCode::P0522};
  if (problems.size() != problems.list().size()) return problems;  // some are only counted
  Problems first(problems.stop());
  std::set<std::pair<ProblemCode, std::string>> seen;
  for (const Problem& problem : problems.list())
    if (std::ranges::find(kMissing, problem.code) == std::end(kMissing) ||
        seen.emplace(problem.code, problem.message).second)
      first.add(problem);
  return first;
}

// "//# KOP" behind BEGIN: STEP 7 made the block of networks in KOP. It changes nothing but the
// places of temporary bits.
block::Language languageOf(const BlockSource& source) {
  Cursor cursor(source.file->text(), source.codeBegin, source.codeEnd);
  while (!cursor.atEnd() && std::isspace(static_cast<unsigned char>(cursor.peek())) != 0)
    cursor.take();
  if (!cursor.accept('/') || !cursor.accept('/') || !cursor.accept('#'))
    return block::Language::Awl;
  if (cursor.acceptWord("KOP")) return block::Language::Kop;
  return cursor.acceptWord("FUP") ? block::Language::Fup : block::Language::Awl;
}

}  // namespace

// The first byte behind the declared temporary variables; not rounded up to a word (code patterns,
// section 1).
std::uint32_t BlockCompiler::firstFreeLocalByte() const {
  std::uint32_t bits = target_.id.kind == BlockKind::OB ? kStartInformation * 8 : 0;
  for (const block::Variable& variable : target_.variables)
    if (variable.section == block::Section::Temp)
      bits = std::max(bits, variable.address + block::sizeInBits(*variable.type));
  return (bits + 7) / 8;
}

void BlockCompiler::compile() {
  declaredTop_ = firstFreeLocalByte();
  target_.language = languageOf(source_);
  // Absolute local data (LW 30) may lie behind the declared variables; what the macros need must
  // lie behind both.
  if (!pass(declaredTop_)) pass(isGraphic() ? declaredTop_ : localTop_);
  const std::uint32_t top = std::max({target_.localBytes, localTop_, localData_.top()});
  target_.localBytes = (top + 1) & ~1u;
  if (target_.localBytes > scope_.model().localBytes)  // S7-CPU-25
    problems_.add(ProblemCode::P0507, at(source_.name.begin, source_.name.end),
                  toString(target_.id), target_.localBytes, scope_.model().localBytes,
                  scope_.model().name);
  if (builder_->code().size() > std::min(scope_.model().blockSize, 65'534u))  // S7-LIM-03
    problems_.add(ProblemCode::P0503, at(source_.name.begin, source_.name.end),
                  toString(target_.id), builder_->code().size(), scope_.model().blockSize);
  builder_->moveInto(target_);
  finalProblems_.append(firstUses(problems_));
}

// False if the transfer areas of this pass overlap local data that the program uses absolutely.
bool BlockCompiler::pass(std::uint32_t localBase) {
  problems_ = Problems(finalProblems_.stop());
  use_ = {};
  cursor_ = Cursor(source_.file->text(), source_.codeBegin, source_.codeEnd, problems_.stop());
  builder_ = std::make_unique<CodeBuilder>();
  brackets_.clear();
  labels_.clear();
  jumps_.clear();
  relays_.clear();
  ended_ = reportedAfterEnd_ = any_ = false;
  networkTops_.restart();
  if (isGraphic()) localTop_ = 0;
  localData_ = LocalData(std::max(localBase, networkTops_.next()));
  for (;;) {
    cursor_.skipSpace();
    checks();
    if (cursor_.atEnd()) break;
    statement();
  }
  endOfBlock();
  const bool fits = localTop_ <= localBase || !localData_.used();
  networkTops_.end(localTop_);
  if (!isGraphic()) return fits;
  localTop_ = networkTops_.highest();
  return localTop_ <= localBase;
}

void BlockCompiler::skipStatement() {
  while (!cursor_.atStatementEnd()) {
    const char c = cursor_.take();
    if (c != '\'' && c != '"') continue;
    while (!cursor_.atEnd() && cursor_.peek() != '\n' && cursor_.take() != c) continue;
  }
  cursor_.accept(';');
}

void BlockCompiler::checks() {
  std::vector<CheckComment> comments = std::move(cursor_.checks());
  cursor_.checks().clear();
  if (!options_.checks) return;
  for (const CheckComment& comment : comments) {
    const Position position = at(comment.begin, comment.end);
    if (!any_) {
      problems_.add(ProblemCode::P0901, position);
      continue;
    }
    Scope scope = scope_;
    scope.anyMnemonics = true;
    scope.use = nullptr;
    localData_.begin();  // the statement is over
    auto check = parseCheckComment(comment, scope, localData_, problems_);
    if (!check) continue;
    check->offset = builder_->lastInstruction();
    check->position = position;
    builder_->checks().push_back(std::move(*check));
  }
}

// "M001:" in front of a statement, or alone.
bool BlockCompiler::label() {
  const std::size_t begin = cursor_.pos();
  const std::string_view word = cursor_.word();
  cursor_.skipBlanks();
  if (word.empty() || cursor_.peek() != ':' || cursor_.peek(1) == '=') {
    cursor_.seek(begin);
    return false;
  }
  cursor_.take();
  labelDefinition(word, begin);
  return true;
}

void BlockCompiler::statement() {
  if (cursor_.accept(';') || label()) return;
  const std::size_t begin = cursor_.pos();
  const Position position = at(begin, begin + 1);
  if (const std::string_view word = cursor_.word(); !word.empty() && networkHeader(word)) return;
  cursor_.seek(begin);
  const std::string name = readMnemonic(cursor_);
  if (ended_ && !reportedAfterEnd_) {
    problems_.add(ProblemCode::P0331, position);
    reportedAfterEnd_ = true;
  }
  localData_.begin();
  builder_->line(position.line, position.column);
  instruction(name, begin);
  checks();
}

void BlockCompiler::labelDefinition(std::string_view word, std::size_t begin) {
  const Position position = at(begin, begin + word.size());
  if (characterCount(word) > 4) problems_.add(ProblemCode::P0332, position, std::string(word));
  labels_.push_back({std::string(word), bracket(), position});
  builder_->label(std::string(word), position, problems_);  // labels keep their case
}

void BlockCompiler::nextNetwork() {
  networkTops_.end(localTop_);
  localTop_ = 0;
  localData_.moveTo(std::max(declaredTop_, networkTops_.next()));
}

bool BlockCompiler::networkHeader(std::string_view word) {
  if (equalsIgnoreCase(word, "NETWORK")) {
    endOfNetwork();
    if (isGraphic()) nextNetwork();
    builder_->network({});
    cursor_.accept(';');
    return true;
  }
  if (!equalsIgnoreCase(word, "TITLE")) return false;
  const std::size_t saved = cursor_.pos();
  if (!cursor_.accept('=')) {
    cursor_.seek(saved);
    return false;
  }
  const std::size_t begin = cursor_.pos();
  cursor_.skipLine();
  builder_->networkTitle(std::string(trim(cursor_.slice(begin, cursor_.pos()))));
  return true;
}

// A word that exists only in the other mnemonics is clear, one that is another instruction there is
// not if the source mixes both (S7-SRC-10).
std::optional<Operation> BlockCompiler::operationOf(const std::string& name, std::size_t begin) {
  const Mnemonics other =
      scope_.mnemonics == Mnemonics::German ? Mnemonics::International : Mnemonics::German;
  const auto own = mc7::findOperation(name, scope_.mnemonics);
  const auto foreign = mc7::findOperation(name, other);
  if (!own && foreign) noteForeign(scope_, name, at(begin, cursor_.pos()));
  if (own && foreign && *own != *foreign)
    use_.ambiguous.push_back(makeProblem(ProblemCode::P0357, at(begin, cursor_.pos()), name));
  return own ? own : foreign;
}

void BlockCompiler::instruction(const std::string& name, std::size_t begin) {
  if (name == "CALL") {
    CallCompiler call(*this);
    if (call.compile(begin))
      endOfStatement();
    else
      skipStatement();
    any_ = true;
    ended_ = false;
    return;
  }
  const auto operation = operationOf(name, begin);
  if (!operation) {
    problems_.add(ProblemCode::P0334, at(begin, cursor_.pos()), name);
    skipStatement();
    return;
  }
  const std::size_t before = problems_.size();
  if (isJump(*operation))
    jump(*operation, begin);
  else
    operate(*operation, begin, name);
  any_ = true;
  const bool bracket = *operation >= Operation::AND_OPEN && *operation <= Operation::XOR_NOT_OPEN;
  if (problems_.size() != before)
    skipStatement();
  else if (bracket)
    cursor_.accept(';');  // U( O E 0.0 may stand on one line
  else
    endOfStatement();
}

void BlockCompiler::endOfStatement() {
  if (cursor_.accept(';')) return;
  if (cursor_.atLineEnd()) return;
  problems_.add(ProblemCode::P0302, here(), std::string(1, cursor_.peek()));
  skipStatement();
}

// Passes the label and says where it begins. It may stand alone on the next line.
std::size_t BlockCompiler::jumpLabel() {
  cursor_.skipBlanks();
  const std::size_t end = cursor_.pos();
  if (cursor_.atLineEnd()) cursor_.skipSpace();
  const std::size_t begin = cursor_.pos();
  cursor_.word();
  if (cursor_.atStatementEnd() || begin == end) {
    cursor_.seek(begin);
    cursor_.word();
    return begin;
  }
  cursor_.seek(end);
  return end;
}

void BlockCompiler::jump(Operation operation, std::size_t begin) {
  ended_ = false;
  const std::size_t labelBegin = jumpLabel();
  const std::string label(cursor_.slice(labelBegin, cursor_.pos()));
  if (label.empty()) {
    problems_.add(ProblemCode::P0335, at(begin, cursor_.pos()));
    return;
  }
  jumps_.push_back({label, bracket(), {}});
  if (operation == Operation::SPL)
    builder_->jumpList(label, at(labelBegin, cursor_.pos()));
  else
    builder_->jump(operation, label, at(labelBegin, cursor_.pos()));
}

void BlockCompiler::endOfNetwork() {
  for (const std::size_t open : brackets_)
    problems_.add(ProblemCode::P0344, at(open, open + 1));  // S7-BRACKET-01, -02
  brackets_.clear();
}

// A label inside brackets is harmless for a jump from the same bracket, as EN of a KOP box makes
// it; a jump from outside enters the bracket in the middle (S7-BRACKET-03).
void BlockCompiler::checkJumpsIntoBrackets() {
  std::map<std::string_view, std::set<std::size_t>> from;  // brackets with jumps, by label
  for (const Place& jump : jumps_) from[jump.label].insert(jump.bracket);
  for (const Place& label : labels_) {
    const auto jumps = from.find(label.label);
    if (label.bracket == 0 || jumps == from.end()) continue;
    if (jumps->second.size() > 1 || !jumps->second.contains(label.bracket))
      problems_.add(ProblemCode::P0333, label.position, label.label);
  }
}

void BlockCompiler::endOfBlock() {
  endOfNetwork();
  checkJumpsIntoBrackets();
  for (const std::size_t open : relays_) problems_.add(ProblemCode::P0345, at(open, open + 1));
  (void)emit(Operation::BE);  // also behind a BE of the source (code patterns, section 5)
  builder_->resolveJumps(problems_);
}

}  // namespace merker::step7
