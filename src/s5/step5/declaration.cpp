#include "step5/declaration.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "mc5/constant.h"
#include "step5/comment.h"
#include "step5/line_start.h"
#include "step5/scanner.h"

namespace merker::step5 {
namespace {

using mc5::Format;
using mc5::Parameter;
using mc5::ParameterKind;
using mc5::Width;

constexpr std::size_t kMostKept = 1000;  // of too many: uses of most are no further problems
constexpr std::size_t kParameters = 40, kNameCharacters = 4, kBlockNameCharacters = 8;

constexpr std::array kKindLetters{'E', 'A', 'D', 'B', 'T', 'Z'};

struct Type {
  std::string_view word;
  Width width;
};
constexpr std::array kTypes{Type{"BI", Width::Bit}, Type{"BY", Width::Byte}, Type{"W", Width::Word},
                            Type{"D", Width::Double}};
constexpr std::string_view kDataTypes = "KM KH KY KC KT KZ KF KG";

bool hasType(ParameterKind kind) {
  return kind == ParameterKind::Input || kind == ParameterKind::Output ||
         kind == ParameterKind::Data;
}

class Reader {
 public:
  Reader(const BlockSource& source, Problems& problems) : source_(source), problems_(problems) {}

  Declaration read() {
    result_.name = source_.name;
    for (const Line& line : source_.lines) {
      if (!take(line)) break;
      ++result_.lines;
    }
    return std::move(result_);
  }

 private:
  // False at the first line that is none of the declaration.
  bool take(const Line& line) {
    Scanner scanner(line.text, line.offset);
    scanner.skipBlanks();
    if (scanner.rest().starts_with("//=")) return false;  // a check
    if (isComment(scanner)) return comment(scanner);
    const std::string word = uppercase(scanner.take(isLetter));
    if (word == "NETZWERK" || word == "SEGMENT") return true;
    scanner.skipBlanks();
    if ((word != "NAME" && word != "BEZ") || !scanner.accept(':')) return false;
    scanner.skipBlanks();
    if (word == "NAME")
      name(scanner);
    else
      parameter(scanner);
    return comment(scanner);
  }

  // What is left of the line.
  bool comment(const Scanner& scanner) {
    result_.comments.push_back(commentText(scanner.rest()));
    return true;
  }

  void name(Scanner& scanner) {
    const std::size_t offset = scanner.offset();
    const std::string_view rest = scanner.rest();
    const std::size_t end = std::min({rest.find_first_of("!;"), rest.find("//"), rest.size()});
    std::string text(rest.substr(0, end));
    scanner.skip(end);
    while (!text.empty() && isBlank(text.back())) text.pop_back();
    if (text.size() > kBlockNameCharacters) tooLong(text, offset, kBlockNameCharacters);
    result_.nameLine = text;
    if (source_.name.empty()) result_.name = text;
  }

  void tooLong(const std::string& text, std::size_t offset, std::size_t limit) {
    problems_.add(ProblemCode::P1119, at(offset, text.size()), text, text.size(), limit, "");
  }

  // BEZ : BEAR  E/A/D/B/T/Z: E  BI/BY/W/D: BI; the masks of the programmer may be left out.
  void parameter(Scanner& scanner) {
    Parameter parameter;
    const std::size_t offset = scanner.offset();
    parameter.name = uppercase(scanner.take(isNameCharacter));
    if (parameter.name.size() > kNameCharacters) tooLong(parameter.name, offset, kNameCharacters);
    if (parameter.name.empty() || !isLetter(parameter.name.front()))
      problems_.add(ProblemCode::P1147, at(offset, parameter.name.size()), parameter.name);
    if (!kind(scanner, parameter)) return;
    if (hasType(parameter.kind) ? !type(scanner, parameter) : !noType(scanner, parameter)) return;
    keep(std::move(parameter), offset);
  }

  void keep(Parameter parameter, std::size_t offset) {
    auto& list = result_.parameters;
    const bool twice = std::any_of(list.begin(), list.end(),
                                   [&](const Parameter& p) { return p.name == parameter.name; });
    if (twice) problems_.add(ProblemCode::P1140, at(offset, parameter.name.size()), parameter.name);
    if (list.size() == kParameters)
      problems_.add(ProblemCode::P1130, at(offset, parameter.name.size()));
    if (list.size() > kMostKept) return;
    list.push_back(std::move(parameter));
  }

  // The word behind an optional mask "E/A/D/B/T/Z:".
  std::string answer(Scanner& scanner, std::size_t& offset) {
    scanner.skipBlanks();
    const std::size_t mark = scanner.mark();
    scanner.take([](char c) { return isLetter(c) || c == '/'; });
    scanner.skipBlanks();
    if (!scanner.accept(':')) scanner.back(mark);
    scanner.skipBlanks();
    offset = scanner.offset();
    return uppercase(scanner.take(isLetter));
  }

  bool kind(Scanner& scanner, Parameter& parameter) {
    std::size_t offset = 0;
    const std::string word = answer(scanner, offset);
    for (std::size_t i = 0; i < kKindLetters.size(); ++i)
      if (word.size() == 1 && word[0] == kKindLetters[i]) {
        parameter.kind = static_cast<ParameterKind>(i);
        return true;
      }
    problems_.add(ProblemCode::P1128, at(offset, word.size()), word);
    return false;
  }

  bool type(Scanner& scanner, Parameter& parameter) {
    std::size_t offset = 0;
    const std::string word = answer(scanner, offset);
    const bool data = parameter.kind == ParameterKind::Data;
    if (data ? dataType(word, parameter) : addressType(word, parameter)) return true;
    problems_.add(ProblemCode::P1129, at(offset, word.size()), word,
                  kKindLetters[static_cast<std::size_t>(parameter.kind)],
                  data ? kDataTypes : "BI BY W D");
    return false;
  }

  // Kinds B, T and Z have none (S5-FB-12); free text may follow.
  bool noType(Scanner scanner, const Parameter& parameter) {
    std::size_t offset = 0;
    Parameter ignored;
    const std::string word = answer(scanner, offset);
    if (!addressType(word, ignored) && !dataType(word, ignored)) return true;
    problems_.add(ProblemCode::P1148, at(offset, word.size()),
                  kKindLetters[static_cast<std::size_t>(parameter.kind)], word);
    return false;
  }

  static bool dataType(const std::string& word, Parameter& parameter) {
    const mc5::ConstantFormat* format = mc5::findConstantFormat(word);
    if (format == nullptr || kDataTypes.find(word) == std::string_view::npos) return false;
    parameter.format = format->format;
    return true;
  }

  static bool addressType(const std::string& word, Parameter& parameter) {
    for (const Type& row : kTypes)
      if (row.word == word) {
        parameter.width = row.width;
        return true;
      }
    return false;
  }

  Position at(std::size_t offset, std::size_t length) const {
    return source_.file->position(offset, std::max<std::size_t>(length, 1));
  }

  const BlockSource& source_;
  Problems& problems_;
  Declaration result_;
};

}  // namespace

Declaration readDeclaration(const BlockSource& source, Problems& problems) {
  return Reader(source, problems).read();
}

std::string typeText(const Parameter& parameter) {
  const char letter = kKindLetters[static_cast<std::size_t>(parameter.kind)];
  if (parameter.kind == ParameterKind::Data)
    return fmt::format("{} {}", letter, mc5::info(parameter.format).word);
  if (!hasType(parameter.kind)) return std::string(1, letter);
  for (const Type& row : kTypes)
    if (row.width == parameter.width) return fmt::format("{} {}", letter, row.word);
  return std::string(1, letter);
}

std::uint32_t wordCount(const Parameter& parameter) {
  return parameter.kind == ParameterKind::Data && parameter.format == Format::Float ? 2 : 1;
}

std::vector<std::uint32_t> parameterWords(const std::vector<Parameter>& parameters) {
  std::vector<std::uint32_t> words;
  std::uint32_t next = 1;
  for (const Parameter& parameter : parameters) {
    words.push_back(next);
    next += wordCount(parameter);
  }
  return words;
}

}  // namespace merker::step5
