#include "base/code_page.h"

#include <iconv.h>

#include <cstdint>

#include "base/text.h"
#include "base/utf8.h"

namespace merker {
namespace {

std::string nameOf(unsigned page) { return page == 20866 ? "KOI8-R" : "CP" + std::to_string(page); }

}  // namespace

class CharacterConverter {
 public:
  CharacterConverter(const std::string& to, const std::string& from)
      : handle_(iconv_open(to.c_str(), from.c_str())) {}
  CharacterConverter(const CharacterConverter&) = delete;
  ~CharacterConverter() {
    if (good()) iconv_close(handle_);
  }
  bool good() const { return handle_ != reinterpret_cast<iconv_t>(-1); }

  // Appends what `bytes` are in the other encoding; false if they are not whole characters of both.
  bool convert(std::string_view bytes, std::string& out) const {
    if (!good()) return false;
    char* from = const_cast<char*>(bytes.data());
    std::size_t left = bytes.size();
    std::array<char, 8> text{};
    char* to = text.data();
    std::size_t room = text.size();
    iconv(handle_, nullptr, nullptr, nullptr, nullptr);
    if (iconv(handle_, &from, &left, &to, &room) != 0 || left != 0) return false;
    out.append(text.data(), text.size() - room);
    return true;
  }

  // Appends the first character of `bytes`; the number of its bytes, 0 if there is none.
  std::size_t character(std::string_view bytes, std::string& out) const {
    for (std::size_t length = 1; length <= 2 && length <= bytes.size(); ++length)
      if (convert(bytes.substr(0, length), out)) return length;
    return 0;
  }

 private:
  iconv_t handle_;
};

namespace {

bool severalBytes(unsigned page) {
  return page == 932 || page == 936 || page == 949 || page == 950 || page == 1361;
}

}  // namespace

CodePage::CodePage(unsigned number) : number_(number), wide_(severalBytes(number)) {
  if (!CharacterConverter("UTF-8", nameOf(number_)).good()) number_ = 1252, wide_ = false;
  const CharacterConverter converter("UTF-8", nameOf(number_));
  for (std::size_t i = 0; i < upper_.size(); ++i) {
    const char byte = static_cast<char>(0x80 + i);
    if (converter.character({&byte, 1}, upper_[i]) == 0) appendCharacter(upper_[i], kReplacement);
  }
}

std::string CodePage::toUtf8(std::string_view bytes) const {
  std::string out;
  out.reserve(bytes.size());
  if (!wide_) {
    for (const char c : bytes) {
      const auto byte = static_cast<std::uint8_t>(c);
      byte < 0x80 ? out.push_back(c) : void(out.append(upper_[byte - 0x80u]));
    }
    return out;
  }
  const CharacterConverter converter("UTF-8", nameOf(number_));
  while (!bytes.empty()) {
    std::size_t length = 1;
    if (static_cast<std::uint8_t>(bytes[0]) < 0x80)
      out.push_back(bytes[0]);
    else if ((length = converter.character(bytes, out)) == 0)
      appendCharacter(out, kReplacement), length = 1;
    bytes.remove_prefix(length);
  }
  return out;
}

struct Encoder::Handle {
  explicit Handle(unsigned page) : converter(nameOf(page), "UTF-8") {}
  CharacterConverter converter;
};

Encoder::Encoder(unsigned page) : handle_(std::make_shared<Handle>(page)) {}

const std::optional<std::string>& Encoder::bytesOf(std::string_view character) {
  const auto found = known_.find(character);
  if (found != known_.end()) return found->second;
  // A text from outside may have every character there is.
  constexpr std::size_t kMostKnown = 20'000;
  if (known_.size() >= kMostKnown) known_.clear();
  std::string bytes;
  const bool has = handle_->converter.convert(character, bytes);
  return known_
      .emplace(std::string(character), has ? std::optional(std::move(bytes)) : std::nullopt)
      .first->second;
}

std::string Encoder::encode(std::string_view utf8) {
  std::string out;
  out.reserve(utf8.size());
  for (std::size_t at = 0; at < utf8.size();) {
    const std::size_t begin = at;
    nextCharacter(utf8, at);
    if (at - begin == 1 && isAscii(utf8.substr(begin, 1)))
      out += utf8[begin];
    else
      out += bytesOf(utf8.substr(begin, at - begin)).value_or("?");
  }
  return out;
}

std::optional<std::string> windowsBytes(std::string_view character) {
  thread_local std::map<unsigned, Encoder> encoders;
  if (encoders.empty())
    for (const unsigned page : kWindowsPages) encoders.emplace(page, Encoder(page));
  for (const unsigned page : kWindowsPages)
    if (const auto& bytes = encoders.at(page).bytesOf(character)) return bytes;
  return std::nullopt;
}

}  // namespace merker
