#include "step7/initial_value.h"

#include <algorithm>
#include <string>

#include "address/constant.h"
#include "base/bytes.h"
#include "base/text.h"
#include "step7/declaration.h"
#include "step7/pointer_value.h"

namespace merker::step7 {
void storeElementary(std::vector<std::uint8_t>& image, BitAddress at, TypeCode type,
                     std::uint32_t bits) {
  const std::size_t byte = at / 8;
  const unsigned width = bitWidth(type);
  if (image.size() < byte + (width + 7) / 8) image.resize(byte + (width + 7) / 8);
  if (width == 1) {
    const auto mask = static_cast<std::uint8_t>(1u << (at & 7));
    image[byte] = static_cast<std::uint8_t>(bits ? image[byte] | mask : image[byte] & ~mask);
  } else if (width == 8) {
    image[byte] = static_cast<std::uint8_t>(bits);
  } else if (width == 16) {
    storeWord(&image[byte], bits);
  } else {
    storeDWord(&image[byte], bits);
  }
}

namespace {

class InitialReader {
 public:
  InitialReader(const source::SourceFile& file, std::size_t begin, std::size_t end,
                Problems& problems)
      : file_(file), cursor_(file.text(), begin, end, problems.stop()), problems_(problems) {}

  std::optional<std::vector<std::uint8_t>> read(const block::Type& type) {
    if (block::sizeInBytes(type) > kLargest) return std::nullopt;  // reported
    std::vector<std::uint8_t> image(block::sizeInBytes(type));
    block::Variable whole;
    whole.type = std::make_shared<block::Type>(type);
    block::writeInitial(whole, 0, image);
    const bool good = type.code == TypeCode::Array ? array(type, image) : single(type, 0, image);
    if (!good) return std::nullopt;
    cursor_.skipSpace();
    if (!cursor_.atEnd()) {
      problems_.add(ProblemCode::P0302, here(), std::string(1, cursor_.peek()));
      return std::nullopt;
    }
    return image;
  }

 private:
  Position here(std::size_t begin, std::size_t end) const {
    return file_.position(begin, std::max(end, begin + 1) - begin);
  }
  Position here() const { return here(cursor_.pos(), cursor_.pos() + 1); }

  // The text of one value: up to , ( ) or the end; commas and brackets of B#(1,2) and of 'strings'
  // belong to it.
  std::string_view valueText(std::size_t& begin) {
    cursor_.skipSpace();
    begin = cursor_.pos();
    if (cursor_.peek() == '\'') {
      cursor_.take();
      while (!cursor_.atEnd()) {
        const char c = cursor_.take();
        if (c == '$')
          cursor_.take();
        else if (c == '\'' && cursor_.peek() == '\'')
          cursor_.take();
        else if (c == '\'')
          break;
      }
    } else {
      while (!cursor_.atEnd() && cursor_.peek() != ',' && cursor_.peek() != ')' &&
             cursor_.peek() != '(' && !(cursor_.peek() == '/' && cursor_.peek(1) == '/')) {
        const bool bytes = cursor_.take() == '#' && cursor_.peek() == '(';
        if (bytes)
          while (!cursor_.atEnd() && cursor_.take() != ')') continue;
      }
    }
    return trim(cursor_.slice(begin, cursor_.pos()));
  }

  bool array(const block::Type& type, std::vector<std::uint8_t>& image) {
    std::size_t next = 0;
    return list(type, block::elementOffsets(type), next, image);
  }

  bool list(const block::Type& type, const std::vector<BitAddress>& places, std::size_t& next,
            std::vector<std::uint8_t>& image) {
    do {
      cursor_.skipSpace();
      const std::size_t begin = cursor_.pos();
      const auto factor = repetition();
      if (factor) {
        cursor_.skipSpace();
        const std::size_t first = next, values = cursor_.pos();
        if (*factor == 0 || depth_ == kDeepest) return problem(begin);
        ++depth_;
        const bool good = list(type, places, next, image);
        --depth_;
        if (!good || !repeat(type, places, values, first, next, *factor - 1, image)) return false;
        cursor_.skipSpace();
        if (!cursor_.accept(')')) return problem(begin);
        continue;
      }
      if (next >= places.size()) {
        problems_.add(ProblemCode::P0413, here(), places.size());
        return false;
      }
      if (!single(*type.element, places[next++], image)) return false;
    } while (cursor_.accept(','));
    return true;
  }

  // The values in the brackets are read once, whatever stands between them.
  bool repeat(const block::Type& type, const std::vector<BitAddress>& places, std::size_t values,
              std::size_t first, std::size_t& next, std::int64_t times,
              std::vector<std::uint8_t>& image) {
    const std::size_t count = (next - first) * static_cast<std::size_t>(times);
    if (count > places.size() - next) {
      problems_.add(ProblemCode::P0413, here(values, values + 1), places.size());
      return false;
    }
    for (const std::size_t end = next + count; next < end; ++next, ++first)
      copy(*type.element, places[first], places[next], image);
    return true;
  }

  static void copy(const block::Type& element, BitAddress from, BitAddress to,
                   std::vector<std::uint8_t>& image) {
    if (element.code == TypeCode::Bool) {
      storeElementary(image, to, TypeCode::Bool, image[from / 8] >> from % 8 & 1u);
      return;
    }
    std::copy_n(image.begin() + from / 8, block::sizeInBytes(element), image.begin() + to / 8);
  }

  // "5 (" : five times what stands in the brackets.
  std::optional<std::int64_t> repetition() {
    const std::size_t start = cursor_.pos();
    const auto number = readInteger(cursor_);
    if (number && *number >= 0 && *number <= 65535) {
      cursor_.skipBlanks();
      if (cursor_.accept('(')) return number;
    }
    cursor_.seek(start);
    return std::nullopt;
  }

  bool problem(std::size_t begin) {
    problems_.add(ProblemCode::P0412, here(begin, cursor_.pos()),
                  std::string(trim(cursor_.slice(begin, cursor_.pos()))), "list");
    return false;
  }

  bool single(const block::Type& type, BitAddress at, std::vector<std::uint8_t>& image) {
    std::size_t begin = 0;
    const std::string_view text = valueText(begin);
    const Position place = here(begin, cursor_.pos());
    if (type.code == TypeCode::Void) return true;  // unknown, which is reported
    if (type.code == TypeCode::String) return string(type, text, at, image, place);
    if (type.code == TypeCode::DateAndTime) return dateAndTime(text, at, image, place);
    if (type.code == TypeCode::Any || type.code == TypeCode::Pointer)
      return descriptor(type, begin, at, image, place);
    if (isParameterNumber(type.code)) return parameterNumber(type, text, at, image, place);
    if (!isElementary(type.code)) {
      problems_.add(ProblemCode::P0414, place, block::toString(type));
      return false;
    }
    const auto constant = parseConstant(longNotation(type.code, text), place);
    if (!constant) {
      problems_.add(constant.error());
      return false;
    }
    const auto bits = convertConstant(*constant, type.code);
    if (!bits && tooWide(constant->format, type.code)) {
      problems_.add(ProblemCode::P0432, place, std::string(text), bitWidth(constant->format),
                    block::toString(type), bitWidth(type.code));
      return false;
    }
    if (!bits) {
      problems_.add(ProblemCode::P0412, place, std::string(text), block::toString(type));
      return false;
    }
    storeElementary(image, at, type.code, *bits);
    return true;
  }

  // A declaration says the width: 100000 is a DINT there without L#.
  static std::string longNotation(TypeCode type, std::string_view text) {
    const bool wide = type == TypeCode::DInt || type == TypeCode::DWord;
    const std::size_t digits = text.find_first_not_of("+-");
    const bool number = digits < 2 && text.find_first_not_of("0123456789_", digits) == text.npos;
    return (wide && number ? "L#" : "") + std::string(text);
  }

  bool string(const block::Type& type, std::string_view text, BitAddress at,
              std::vector<std::uint8_t>& image, const Position& place) {
    std::string value;
    if (text.size() < 2 || text.front() != '\'' || text.back() != '\'') {
      problems_.add(ProblemCode::P0412, place, std::string(text), block::toString(type));
      return false;
    }
    const auto characters = parseCharacters(onlyEscapes(text), place);
    if (!characters) {
      problems_.add(characters.error());
      return false;
    }
    const std::string& bytes = *characters;
    if (bytes.size() > type.length) {
      problems_.add(ProblemCode::P0415, place, bytes.size(), type.length);
      return false;
    }
    const std::size_t byte = at / 8;
    image[byte] = static_cast<std::uint8_t>(type.length);
    image[byte + 1] = static_cast<std::uint8_t>(bytes.size());
    for (std::size_t i = 0; i < bytes.size(); ++i)
      image[byte + 2 + i] = static_cast<std::uint8_t>(bytes[i]);
    return true;
  }

  // The notation of character constants; besides, a doubled quotation mark is one.
  static std::string onlyEscapes(std::string_view quoted) {
    std::string out(quoted.substr(0, 1));
    for (std::size_t i = 1; i < quoted.size(); ++i) {
      const bool escape = quoted[i] == '$' && i + 2 < quoted.size();
      const bool twice = quoted[i] == '\'' && i + 2 < quoted.size() && quoted[i + 1] == '\'';
      out += twice ? '$' : quoted[i];
      if (escape || twice) out += quoted[++i];
    }
    return out;
  }

  bool dateAndTime(std::string_view text, BitAddress at, std::vector<std::uint8_t>& image,
                   const Position& place) {
    const auto value = parseDateAndTime(text, place);
    if (!value) {
      problems_.add(value.error());
      return false;
    }
    storeDWord(&image[at / 8], static_cast<std::uint32_t>(*value >> 32));
    storeDWord(&image[at / 8 + 4], static_cast<std::uint32_t>(*value));
    return true;
  }

  // STEP 7 writes P#P 0.0 VOID 0 for an ANY that no call has supplied.
  bool descriptor(const block::Type& type, std::size_t begin, BitAddress at,
                  std::vector<std::uint8_t>& image, const Position& place) {
    const bool any = type.code == TypeCode::Any;
    Cursor text(file_.text(), begin, cursor_.pos());
    const bool written = text.peekWord("P") && text.peek(1) == '#';
    const auto value = written ? readPointer(text, file_, problems_) : std::nullopt;
    if (written && !value) return false;
    if (!value || !text.atLineEnd() || value->type.has_value() != any) {
      problems_.add(ProblemCode::P0412, place,
                    std::string(trim(cursor_.slice(begin, cursor_.pos()))), block::toString(type));
      return false;
    }
    std::uint8_t* to = &image[at / 8];
    if (any) {
      storeWord(to, 0x1000u | static_cast<std::uint32_t>(*value->type));
      storeWord(to + 2, value->count);
      to += 4;
    }
    storeWord(to, value->db);
    storeDWord(to + 2, value->pointer);
    return true;
  }

  bool parameterNumber(const block::Type& type, std::string_view text, BitAddress at,
                       std::vector<std::uint8_t>& image, const Position& place) {
    const std::size_t digits = text.find_first_of("0123456789");
    Cursor digitCursor(text, std::min(digits, text.size()), text.size());
    const auto number = readInteger(digitCursor);
    if (!number || *number > 65535 || !digitCursor.atEnd()) {
      problems_.add(ProblemCode::P0412, place, std::string(text), block::toString(type));
      return false;
    }
    storeWord(&image[at / 8], static_cast<std::uint32_t>(*number));
    return true;
  }

  static constexpr int kDeepest = 32;  // of brackets
  static constexpr std::size_t kLargest = 0x10'0000;

  const source::SourceFile& file_;
  Cursor cursor_;
  Problems& problems_;
  int depth_ = 0;
};

}  // namespace

std::optional<std::vector<std::uint8_t>> readInitialValue(const block::Type& type,
                                                          const source::SourceFile& file,
                                                          std::size_t begin, std::size_t end,
                                                          Mnemonics, Problems& problems) {
  return InitialReader(file, begin, end, problems).read(type);
}

}  // namespace merker::step7
