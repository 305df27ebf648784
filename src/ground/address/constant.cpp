#include "address/constant.h"

#include "address/notation.h"
#include "base/text.h"

namespace merker {
namespace {

using notation::Input;
using notation::misspelt;
using notation::unknown;

bool isBlank(char c) { return c == ' ' || c == '\t'; }
bool isAlphanumeric(char c) { return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z'); }

// Upper case, no blanks beside # - + , : ( and ), for STEP 7 allows them there ("C# 100", "B#(81,
// 54)").
std::string normalise(std::string_view text) {
  const auto joins = [](char c) {
    return std::string_view("#-+,:()").find(c) != std::string_view::npos;
  };
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!isBlank(text[i])) {
      result += text[i];
      continue;
    }
    std::size_t next = i;
    while (next < text.size() && isBlank(text[next])) ++next;
    const bool drop =
        result.empty() || next == text.size() || joins(result.back()) || joins(text[next]);
    if (!drop) result += ' ';
    i = next - 1;
  }
  return upper(result);
}

// Takes the underscores out; false if one does not stand between two letters or digits.
bool dropUnderscores(std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '_') continue;
    const bool inside =
        i > 0 && i + 1 < text.size() && isAlphanumeric(text[i - 1]) && isAlphanumeric(text[i + 1]);
    if (!inside) return false;
  }
  std::erase(text, '_');
  return true;
}

Result<Constant> readCharacters(std::string_view written, const Position& at) {
  const auto bytes = parseCharacters(written, at);
  if (!bytes) return bytes.error();
  if (bytes->empty())
    return makeProblem(ProblemCode::P0209, at, written, "it contains no character");
  if (bytes->size() > 4) return makeProblem(ProblemCode::P0204, at, written, bytes->size());
  std::uint32_t bits = 0;
  for (const char c : *bytes) bits = bits << 8 | static_cast<unsigned char>(c);
  return Constant{bytes->size() <= 2 ? ConstantFormat::Characters : ConstantFormat::LongCharacters,
                  bits};
}

Result<Constant> refuseDateAndTime(const Input& input) {
  return unknown(input,
                 " of 32 bits: DATE_AND_TIME has 64 bits; no instruction can load it as a whole");
}

struct Notation {
  std::string_view prefix;
  Result<Constant> (*read)(const Input&);
};
constexpr Notation kNotations[] = {
    {"B", notation::readByte},
    {"BYTE", notation::readByte},
    {"W", notation::readWord},
    {"WORD", notation::readWord},
    {"DW", notation::readDWord},
    {"DWORD", notation::readDWord},
    {"16", notation::readPlainHexadecimal},
    {"2", notation::readBinary},
    {"C", notation::readCounter},
    {"L", notation::readLongInteger},
    {"P", notation::readPointer},
    {"S5T", notation::readS5Time},
    {"S5TIME", notation::readS5Time},
    {"T", notation::readTime},
    {"TIME", notation::readTime},
    {"D", notation::readDate},
    {"DATE", notation::readDate},
    {"TOD", notation::readTimeOfDay},
    {"TIME_OF_DAY", notation::readTimeOfDay},
    {"DT", refuseDateAndTime},
    {"DATE_AND_TIME", refuseDateAndTime},
};

}  // namespace

Result<Constant> parseConstant(std::string_view text, const Position& at) {
  const std::string_view written = trim(text);
  if (written.starts_with('\'')) return readCharacters(written, at);
  std::string body = normalise(written);
  if (body == "TRUE" || body == "FALSE") return Constant{ConstantFormat::Boolean, body == "TRUE"};
  const std::size_t hash = body.find('#');
  const std::string prefix = body.substr(0, hash == std::string::npos ? 0 : hash);
  if (hash != std::string::npos) body.erase(0, hash + 1);
  const bool wellFormed = dropUnderscores(body);
  const Input input{written, body, at};
  if (!wellFormed) return unknown(input, ": an underscore must be between two digits");
  if (hash == std::string::npos) return notation::readNumber(input);
  for (const Notation& row : kNotations)
    if (row.prefix == prefix) return row.read(input);
  return unknown(input);
}

Result<std::uint64_t> parseDateAndTime(std::string_view text, const Position& at) {
  const std::string_view written = trim(text);
  std::string body = normalise(written);
  const bool prefixed = body.starts_with("DT#") || body.starts_with("DATE_AND_TIME#");
  body.erase(0, prefixed ? body.find('#') + 1 : 0);
  const bool wellFormed = dropUnderscores(body);
  const Input input{written, body, at};
  if (!prefixed || !wellFormed) return misspelt(input, "DT#1998-04-14-17:53:17.333");
  return notation::readDateAndTime(input);
}

}  // namespace merker
