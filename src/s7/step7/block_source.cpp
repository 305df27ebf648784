#include "step7/block_source.h"

#include <algorithm>
#include <array>

#include "base/text.h"
#include "step7/version.h"

namespace merker::step7 {

// The five frames of S7-SRC-01.
struct BlockSplitter::Frame {
  std::string_view begin, end;
  std::array<BlockKind, 2> kinds;
};

namespace {

// Of one source: more than a CPU has, and each takes a kilobyte and a half.
constexpr std::size_t kMostBlocks = 20'000;

std::string_view firstWordOfStatement(Cursor& cursor) {
  const std::size_t start = cursor.pos();
  const std::string_view word = cursor.word();
  cursor.seek(start);
  return word;
}

std::string_view withoutBlanks(std::string_view text) {
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

// Whether TITLE stands alone at the end of the text: what follows its = is free. Only these
// characters are looked at, for a source may have very many of them.
bool endsTitle(std::string_view text) {
  constexpr std::string_view kTitle = "TITLE";
  text = withoutBlanks(text);
  if (text.size() < kTitle.size() ||
      !equalsIgnoreCase(text.substr(text.size() - kTitle.size()), kTitle))
    return false;
  text = withoutBlanks(text.substr(0, text.size() - kTitle.size()));
  return text.empty() || text.back() == '\n' || text.back() == '\r';
}

}  // namespace

std::optional<BlockName> readBlockName(Cursor& cursor, const source::SourceFile& file,
                                       const source::SymbolTable* symbols, Problems& problems) {
  cursor.skipSpace();
  BlockName result;
  result.begin = cursor.pos();
  const auto place = [&] {
    return file.position(result.begin, std::max(cursor.pos(), result.begin + 1) - result.begin);
  };
  const auto named = [&](std::string_view name) {
    result.symbol = name;
    result.end = cursor.pos();
    const source::Symbol* symbol = symbols ? symbols->find(result.symbol) : nullptr;
    if (!symbol)
      problems.add(ProblemCode::P0303, place(), result.symbol);
    else if (symbol->address.kind != source::SymbolAddress::Kind::Block)
      problems.add(ProblemCode::P0304, place(), result.symbol);
    else
      result.id = symbol->address.block;
    return result;
  };
  if (cursor.accept('"')) {
    while (!cursor.atEnd() && cursor.peek() != '"' && cursor.peek() != '\n') cursor.take();
    const std::string_view name = cursor.slice(result.begin + 1, cursor.pos());
    cursor.accept('"');
    return named(name);
  }
  const std::string_view word = cursor.word();
  const std::size_t letters = word.find_first_of("0123456789");
  const auto kind = blockKindFromName(word.substr(0, letters));
  if (isSymbolWord(word, symbols)) {
    problems.add(ProblemCode::P0354, place(), word);
    return named(word);
  }
  if (kind && letters != std::string_view::npos) cursor.seek(result.begin + letters);
  const auto number = kind ? readInteger(cursor) : std::nullopt;
  result.end = cursor.pos();
  if (!number || *number < 0 || *number > 65535) {
    problems.add(ProblemCode::P0305, place());
    return std::nullopt;
  }
  result.id = BlockId{*kind, static_cast<std::uint16_t>(*number)};
  return result;
}

std::vector<BlockSource> BlockSplitter::split() {
  static constexpr std::array<Frame, 5> kFrames{{
      {"ORGANIZATION_BLOCK", "END_ORGANIZATION_BLOCK", {BlockKind::OB, BlockKind::OB}},
      {"FUNCTION", "END_FUNCTION", {BlockKind::FC, BlockKind::SFC}},
      {"FUNCTION_BLOCK", "END_FUNCTION_BLOCK", {BlockKind::FB, BlockKind::SFB}},
      {"DATA_BLOCK", "END_DATA_BLOCK", {BlockKind::DB, BlockKind::DB}},
      {"TYPE", "END_TYPE", {BlockKind::UDT, BlockKind::UDT}},
  }};
  bool reported = false;
  for (;;) {
    cursor_.skipSpace();
    if (cursor_.atEnd()) break;
    const std::size_t begin = cursor_.pos();
    const std::string_view word = cursor_.word();
    const Frame* frame = nullptr;
    for (const Frame& candidate : kFrames)
      if (equalsIgnoreCase(word, candidate.begin)) frame = &candidate;
    if (frame && blocks_.size() == kMostBlocks) {
      problems_.add(ProblemCode::P0106, at(begin, cursor_.pos()), kMostBlocks,
                    "blocks in this source");
      break;
    }
    if (frame) {
      block(*frame, begin);
      reported = false;
      continue;
    }
    if (cursor_.peek() == ';') {
      cursor_.take();
      continue;
    }
    if (!reported) problems_.add(ProblemCode::P0306, at(begin, cursor_.pos()));
    reported = true;
    cursor_.skipLine();
  }
  if (const auto open = cursor_.unclosedComment())
    problems_.add(ProblemCode::P0350, at(*open, *open + 2));
  return std::move(blocks_);
}

void BlockSplitter::block(const Frame& frame, std::size_t begin) {
  BlockSource source;
  source.file = &file_;
  source.id.kind = frame.kinds[0];
  source.codeBegin = source.codeEnd = begin;
  const bool named = blockName(frame, source);
  header(source);
  declarations(frame, source);
  code(frame, source);
  if (named) blocks_.push_back(std::move(source));
}

bool BlockSplitter::blockName(const Frame& frame, BlockSource& source) {
  const auto name = readBlockName(cursor_, file_, symbols_, problems_);
  if (name) source.name = *name;
  if (name && name->id && name->id->kind != frame.kinds[0] && name->id->kind != frame.kinds[1]) {
    problems_.add(ProblemCode::P0307, at(name->begin, name->end), frame.begin,
                  merker::name(frame.kinds[0]));
    return false;
  }
  cursor_.skipSpace();
  if (cursor_.peek() == '{') systemAttributes(source);             // FUNCTION FC 3 { … } : INT
  if (frame.kinds[0] != BlockKind::FC && cursor_.peek() == ':') {  // only a FUNCTION has a type
    problems_.add(ProblemCode::P0302, at(cursor_.pos(), cursor_.pos() + 1), ":");
    cursor_.skipLine();
  }
  if (frame.kinds[0] == BlockKind::FC) {
    if (cursor_.accept(':')) {
      DeclarationParser parser(cursor_, file_, problems_, symbols_);
      source.returnType = parser.type();
    } else if (name) {  // S7-SRC-01
      problems_.add(ProblemCode::P0351, at(name->begin, name->end),
                    cursor_.slice(name->begin, name->end));
    }
  }
  if (!name || !name->id) return false;
  source.id = *name->id;
  return true;
}

std::string BlockSplitter::restOfLine() {
  const std::size_t begin = cursor_.pos();
  cursor_.skipLine();
  return std::string(trim(cursor_.slice(begin, cursor_.pos())));
}

// AUTHOR : x   NAME : 'x'   VERSION : 0.1
std::string BlockSplitter::headerValue() {
  cursor_.accept(':') || cursor_.accept('=');
  cursor_.skipBlanks();
  const std::size_t begin = cursor_.pos();
  while (!cursor_.atStatementEnd()) cursor_.take();
  std::string_view text = trim(cursor_.slice(begin, cursor_.pos()));
  cursor_.accept(';');
  if (text.size() >= 2 && (text.front() == '\'' || text.front() == '"') &&
      text.back() == text.front())
    text = text.substr(1, text.size() - 2);
  return std::string(text);
}

// The comment lines behind the title are the block's comment.
void BlockSplitter::blockComment(BlockSource& source) {
  for (;;) {
    cursor_.skipBlanks();
    if (cursor_.peek() == '\n' || cursor_.peek() == '\r') {
      cursor_.take();
    } else if (cursor_.peek() == '/' && cursor_.peek(1) == '/' &&
               !source.attributes.title.empty()) {
      cursor_.seek(cursor_.pos() + 2);
      if (!source.attributes.comment.empty()) source.attributes.comment += '\n';
      source.attributes.comment += restOfLine();
    } else {
      return;
    }
  }
}

void BlockSplitter::systemAttributes(BlockSource& source) {
  DeclarationParser parser(cursor_, file_, problems_, symbols_);
  source.attributes.system = parser.attributes();
  cursor_.skipSpace();
}

void BlockSplitter::header(BlockSource& source) {
  for (;;) {
    blockComment(source);
    cursor_.skipSpace();
    if (cursor_.peek() == '{')
      systemAttributes(source);
    else if (!headerLine(source))
      return;
  }
}

bool BlockSplitter::headerLine(BlockSource& source) {
  const std::size_t begin = cursor_.pos();
  const std::string key = upper(cursor_.word());
  block::Attributes& attributes = source.attributes;
  const auto text8 = [&](std::string& target) {
    target = headerValue();
    if (characterCount(target) <= 8) return;
    problems_.add(ProblemCode::P0308, at(begin, cursor_.pos()), key);
    while (characterCount(target) > 8) target.pop_back();
  };
  const auto flag = [&](bool& target) {
    target = true;
    cursor_.accept(';');
  };
  if (key == "TITLE") {
    cursor_.accept('=');
    attributes.title = restOfLine();
  } else if (key == "AUTHOR") {
    text8(attributes.author);
  } else if (key == "FAMILY") {
    text8(attributes.family);
  } else if (key == "NAME") {
    text8(attributes.name);
  } else if (key == "VERSION") {
    const std::string value = headerValue();
    if (!validVersion(value)) problems_.add(ProblemCode::P0309, at(begin, cursor_.pos()), value);
    attributes.version = parseVersion(value);
  } else if (key == "KNOW_HOW_PROTECT") {
    flag(attributes.knowHowProtect);
  } else if (key == "CODE_VERSION1") {
    flag(attributes.codeVersion1);
  } else if (key == "READ_ONLY") {
    flag(attributes.readOnly);
  } else if (key == "UNLINKED") {
    flag(attributes.unlinked);
  } else if (key == "NON_RETAIN") {
    flag(attributes.nonRetain);
  } else if (key == "STANDARD") {
    cursor_.accept(';');
  } else {
    cursor_.seek(begin);
    return false;
  }
  return true;
}

void BlockSplitter::declarations(const Frame& frame, BlockSource& source) {
  if (frame.kinds[0] == BlockKind::DB || frame.kinds[0] == BlockKind::UDT)
    return dataDeclaration(source);
  static constexpr std::pair<std::string_view, block::Section> kSections[] = {
      {"VAR_INPUT", block::Section::Input},
      {"VAR_OUTPUT", block::Section::Output},
      {"VAR_IN_OUT", block::Section::InOut},
      {"VAR", block::Section::Static},
      {"VAR_TEMP", block::Section::Temp}};
  for (;;) {
    cursor_.skipSpace();
    const std::size_t begin = cursor_.pos();
    const std::string_view word = cursor_.word();
    const std::pair<std::string_view, block::Section>* found = nullptr;
    for (const auto& section : kSections)
      if (equalsIgnoreCase(word, section.first)) found = &section;
    if (!found) {
      cursor_.seek(begin);
      break;
    }
    declarationSection(source, found->second, begin);
  }
  // The interface has the order of S7-SRC-04 whatever the source has.
  std::stable_sort(
      source.variables.begin(), source.variables.end(),
      [](const VariableSyntax& a, const VariableSyntax& b) { return a.section < b.section; });
}

void BlockSplitter::checkSectionOrder(const BlockSource& source, block::Section section,
                                      std::size_t begin) {
  const bool allowed = section == block::Section::Temp || source.id.kind == BlockKind::FB ||
                       source.id.kind == BlockKind::SFB ||
                       ((source.id.kind == BlockKind::FC || source.id.kind == BlockKind::SFC) &&
                        section != block::Section::Static);
  // S7-EDIT-03: stat only in an FB, only temp in an OB. A VAR section in FC or OB is what older
  // sources use for temp.
  if (!allowed)
    problems_.add(ProblemCode::P0408, at(begin, cursor_.pos()),
                  std::string(cursor_.slice(begin, cursor_.pos())), merker::name(source.id.kind));
  if (!source.variables.empty() && source.variables.back().section > section)
    problems_.add(ProblemCode::P0409, at(begin, cursor_.pos()),
                  std::string(cursor_.slice(begin, cursor_.pos())));
}

void BlockSplitter::declarationSection(BlockSource& source, block::Section section,
                                       std::size_t begin) {
  const std::size_t sectionEnd = cursor_.pos();
  checkSectionOrder(source, section, begin);
  DeclarationParser parser(cursor_, file_, problems_, symbols_);
  while (parser.variables(section, source.variables)) continue;
  if (!cursor_.acceptWord("END_VAR") && !cursor_.unclosedComment())
    problems_.add(ProblemCode::P0410, at(begin, sectionEnd),
                  std::string(cursor_.slice(begin, sectionEnd)));
  cursor_.accept(';');
}

void BlockSplitter::dataDeclaration(BlockSource& source) {
  cursor_.skipSpace();
  const std::size_t begin = cursor_.pos();
  const std::string_view word = firstWordOfStatement(cursor_);
  if (word.empty() && cursor_.peek() != '"') {
    problems_.add(ProblemCode::P0411, at(begin, begin + 1), toString(source.id));
    return;
  }
  if (equalsIgnoreCase(word, "BEGIN") || upper(word).starts_with("END_")) {
    problems_.add(ProblemCode::P0411, at(begin, begin + word.size()), toString(source.id));
    return;
  }
  DeclarationParser parser(cursor_, file_, problems_, symbols_);
  source.dataType = parser.type();
  if (!source.dataType)
    while (!cursor_.atStatementEnd()) cursor_.take();
  cursor_.skipBlanks();
  cursor_.accept(';');
  header(source);  // some write it behind the type
}

void BlockSplitter::code(const Frame& frame, BlockSource& source) {
  cursor_.skipSpace();
  if (cursor_.acceptWord("BEGIN")) cursor_.accept(';');
  source.codeBegin = cursor_.pos();
  bool statementStart = true;
  while (!cursor_.atEnd()) {
    const char c = cursor_.peek();
    if (statementStart && isWordStart(c)) {
      const std::size_t begin = cursor_.pos();
      const std::string_view word = cursor_.word();
      if (equalsIgnoreCase(word, frame.end)) {
        source.codeEnd = begin;
        return;
      }
      static constexpr std::string_view kBegins[] = {"ORGANIZATION_BLOCK", "FUNCTION",
                                                     "FUNCTION_BLOCK", "DATA_BLOCK", "TYPE"};
      bool next = upper(word).starts_with("END_");
      for (const std::string_view keyword : kBegins) next = next || equalsIgnoreCase(word, keyword);
      if (next && (cursor_.atStatementEnd() || !upper(word).starts_with("END_"))) {
        problems_.add(ProblemCode::P0310, at(begin, cursor_.pos()), toString(source.id), frame.end);
        source.codeEnd = begin;
        if (!upper(word).starts_with("END_")) cursor_.seek(begin);
        return;
      }
      statementStart = false;
    } else if (c == '\'') {
      cursor_.passText();
      statementStart = false;
    } else if (c == '"') {
      cursor_.take();
      while (!cursor_.atEnd() && cursor_.peek() != '\n' && cursor_.take() != '"') continue;
      statementStart = false;
    } else if (c == '/' && cursor_.peek(1) == '/') {
      cursor_.skipLine();
    } else if (c == '(' && cursor_.peek(1) == '*') {
      cursor_.skipBlanks();
    } else {
      statementStart =
          c == '\n' || c == '\r' || c == ';' || (statementStart && (c == ' ' || c == '\t'));
      cursor_.take();
      if (c == '=' && endsTitle(file_.text().substr(0, cursor_.pos() - 1))) cursor_.skipLine();
    }
  }
  source.codeEnd = cursor_.pos();
  if (cursor_.unclosedComment()) return;
  problems_.add(ProblemCode::P0310, at(source.name.begin, source.name.end), toString(source.id),
                frame.end);
}

}  // namespace merker::step7
