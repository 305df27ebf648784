#include "step5/block_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "step5/comment.h"
#include "step5/line_start.h"
#include "step5/scanner.h"

namespace merker::step5 {
namespace {

using mc5::BlockType;

struct Kind {
  std::string_view word;
  BlockType type;
  std::uint32_t lowest, highest;  // S5-BLK-03, S5-BLK-04
};
constexpr std::array kKinds{Kind{"OB", BlockType::Ob, 0, 63}, Kind{"PB", BlockType::Pb, 0, 255},
                            Kind{"SB", BlockType::Sb, 0, 255}, Kind{"FB", BlockType::Fb, 0, 255},
                            Kind{"DB", BlockType::Db, 1, 255}};

constexpr std::size_t kLibraryDigits = 5;
constexpr char kFormFeed = '\f';

const Kind* kindOf(std::string_view word) {
  for (const Kind& kind : kKinds)
    if (word.size() == 2 && upper(word[0]) == kind.word[0] && upper(word[1]) == kind.word[1])
      return &kind;
  return nullptr;
}

std::uint32_t numberOf(std::string_view digits) {
  std::uint32_t value = 0;
  for (const char c : digits)
    if (value < 100'000'000) value = value * 10 + static_cast<std::uint32_t>(c - '0');
  return value;
}

// "BLATT 1", "BLATT  : 12": what a printer puts on each page.
bool isPageLine(Scanner scanner) {
  std::string word(scanner.take(isLetter));
  for (char& c : word) c = upper(c);
  scanner.skipBlanks();
  scanner.accept(':');
  scanner.skipBlanks();
  if (word != "BLATT" || scanner.take(isDigit).empty()) return false;
  scanner.skipBlanks();
  return scanner.atEnd();
}

// Reads the heads of one file.
class Finder {
 public:
  Finder(const source::SourceFile& file, Problems& problems) : file_(file), problems_(problems) {}

  std::vector<BlockSource> find() {
    for (std::uint32_t i = 1; i <= file_.lineCount() && !problems_.cancelled(); ++i)
      take(file_.line(i));
    return std::move(blocks_);
  }

 private:
  void take(std::string_view text) {
    if (text.starts_with(kFormFeed)) text.remove_prefix(1);
    const auto offset = static_cast<std::size_t>(text.data() - file_.text().data());
    Scanner scanner(text, offset);
    scanner.skipBlanks();
    if (isPageLine(scanner)) return;
    if (auto block = head(scanner)) {
      if (blocks_.empty()) block->heading = std::move(heading_);
      blocks_.push_back(std::move(*block));
    } else if (!blocks_.empty()) {
      blocks_.back().lines.push_back({text, offset});
    } else if (isComment(scanner)) {
      if (std::string comment = commentText(scanner.rest()); !comment.empty())
        heading_.push_back(std::move(comment));
    } else if (!complained_) {
      complained_ = true;
      problems_.add(ProblemCode::P1101, file_.position(scanner.offset(), scanner.rest().size()));
    }
  }

  // "FB 140   SPRM-A   BIB=14050"; of the others only their number.
  std::optional<BlockSource> head(Scanner scanner) {
    BlockSource block;
    block.file = &file_;
    block.offset = scanner.offset();
    const std::size_t start = scanner.mark();
    const Kind* kind = kindOf(scanner.take(isLetter));
    scanner.skipBlanks();
    const std::string_view digits = scanner.take(isDigit);
    if (kind == nullptr || digits.empty()) return std::nullopt;
    block.length = scanner.since(start).size();
    const std::uint32_t number = numberOf(digits);
    const std::size_t blanks = scanner.skipBlanks();
    if (!isComment(scanner) && (blanks == 0 || scanner.peek() == ':' || scanner.peek() == '='))
      return std::nullopt;
    if (number < kind->lowest || number > kind->highest)
      problems_.add(ProblemCode::P1102, file_.position(block.offset, block.length),
                    fmt::format("{} {}", kind->word, number),
                    fmt::format("{} {}..{}", kind->word, kind->lowest, kind->highest));
    block.id = {kind->type, static_cast<std::uint16_t>(std::min<std::uint32_t>(number, 999))};
    nameAndLibrary(scanner, block);
    if (isComment(scanner)) block.comment = commentText(scanner.rest());
    return block;
  }

  void nameAndLibrary(Scanner& scanner, BlockSource& block) {
    while (!isComment(scanner) && !isPageLine(scanner)) {
      const std::size_t offset = scanner.offset();
      const std::string_view word = scanner.take([](char c) { return !isBlank(c); });
      if (word.starts_with("BIB="))
        library(word.substr(4), offset + 4, block);
      else if (!word.starts_with("LAE="))  // the length: it is counted
        block.name.append(block.name.empty() ? "" : " ").append(word);
      scanner.skipBlanks();
    }
  }

  void library(std::string_view digits, std::size_t offset, BlockSource& block) {
    const bool number = !digits.empty() && std::all_of(digits.begin(), digits.end(), isDigit);
    if (!number || digits.size() > kLibraryDigits)
      problems_.add(ProblemCode::P1119, file_.position(offset, digits.size()), digits,
                    digits.size(), kLibraryDigits, " (digits of a library number)");
    else
      block.library = numberOf(digits);
  }

  const source::SourceFile& file_;
  Problems& problems_;
  std::vector<BlockSource> blocks_;
  std::vector<std::string> heading_;
  bool complained_ = false;
};

}  // namespace

std::vector<BlockSource> findBlocks(const source::SourceFile& file, Problems& problems) {
  return Finder(file, problems).find();
}

}  // namespace merker::step5
