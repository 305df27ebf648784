// Characters of a project: the code page that its language file names.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace merker::s7p {

class CodePage {
 public:
  // 1252 without a number; a page that this system does not know is 1252 as well.
  explicit CodePage(unsigned number = 1252);
  unsigned number() const { return number_; }
  // Of several bytes a character: 936 and the like.
  bool isWide() const { return wide_; }
  // UTF-8; U+FFFD for what the page does not have.
  std::string toUtf8(std::string_view bytes) const;

 private:
  unsigned number_;
  bool wide_ = false;
  std::array<std::string, 128> upper_;  // of bytes from 80h on
};

}  // namespace merker::s7p
