#include "s7p/code_page.h"

#include <iconv.h>

#include "base/utf8.h"

namespace merker::s7p {
namespace {

class Converter {
 public:
  explicit Converter(unsigned page)
      : handle_(iconv_open("UTF-8", ("CP" + std::to_string(page)).c_str())) {}
  Converter(const Converter&) = delete;
  ~Converter() {
    if (good()) iconv_close(handle_);
  }
  bool good() const { return handle_ != reinterpret_cast<iconv_t>(-1); }

  // Appends the first character of `bytes`; the number of its bytes, 0 if there is none.
  std::size_t character(std::string_view bytes, std::string& out) const {
    for (std::size_t length = 1; length <= 2 && length <= bytes.size(); ++length) {
      char* from = const_cast<char*>(bytes.data());
      std::size_t left = length;
      std::array<char, 8> text{};
      char* to = text.data();
      std::size_t room = text.size();
      iconv(handle_, nullptr, nullptr, nullptr, nullptr);
      if (iconv(handle_, &from, &left, &to, &room) == static_cast<std::size_t>(-1) || left != 0)
        continue;
      out.append(text.data(), text.size() - room);
      return length;
    }
    return 0;
  }

 private:
  iconv_t handle_;
};

bool severalBytes(unsigned page) {
  return page == 932 || page == 936 || page == 949 || page == 950 || page == 1361;
}

}  // namespace

CodePage::CodePage(unsigned number) : number_(number), wide_(severalBytes(number)) {
  if (!Converter(number_).good()) number_ = 1252, wide_ = false;
  const Converter converter(number_);
  for (std::size_t i = 0; i < upper_.size(); ++i) {
    const char byte = static_cast<char>(0x80 + i);
    if (!converter.good() || converter.character({&byte, 1}, upper_[i]) == 0)
      appendCharacter(upper_[i], kReplacement);
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
  const Converter converter(number_);
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

}  // namespace merker::s7p
