// Code pages of Windows and DOS by their numbers, and which of them a text is in.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"

namespace merker {

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

// UTF-8 to the bytes of one page. Not for several threads at once.
class Encoder {
 public:
  explicit Encoder(unsigned page);
  // Of one character; nothing if the page does not have it.
  const std::optional<std::string>& bytesOf(std::string_view character);
  // '?' for what the page does not have.
  std::string encode(std::string_view utf8);

 private:
  struct Handle;
  std::shared_ptr<Handle> handle_;
  std::map<std::string, std::optional<std::string>, std::less<>> known_;
};

// What a user may name: pages of DOS and of Windows; 20866 is KOI8-R.
inline constexpr unsigned kCodePages[] = {437,  850,  852,  866,  932,  936,  949,  950,  1250,
                                          1251, 1252, 1253, 1254, 1255, 1256, 1257, 20866};

// The pages of Windows that programs are written in, most usual first.
inline constexpr unsigned kWindowsPages[] = {1252, 1251, 1254, 1250, 1253, 936};
// Of one character, in the first page of kWindowsPages that has it: CHAR and STRING data. Nothing
// if none has.
std::optional<std::string> windowsBytes(std::string_view character);

// The page of DOS or Windows that a text without ASCII alone is most likely in, by how frequent its
// letters are in languages (languages.inc). Not certain: another one is almost as likely.
struct PageGuess {
  unsigned page = 0;  // 0: the text is ASCII
  bool certain = true;
};
PageGuess guessedPage(std::string_view bytes);

// How the characters of a file are stored.
struct TextForm {
  Encoding encoding = Encoding::Utf8;  // Binary: it is no text
  PageGuess guess;                     // without a page: Unicode or ASCII
};
TextForm formOf(std::string_view bytes);

// A text file as UTF-8: what is not Unicode is in `page`, 0: by its content. Nothing if it is
// binary.
std::optional<std::string> decoded(std::string_view bytes, unsigned page = 0);

}  // namespace merker
