#include "itcp/letter.h"

#include <fmt/format.h>

#include "base/text.h"
#include "itcp/escape.h"
#include "itcp/quoted_printable.h"

namespace merker::itcp {
namespace {

// CR, LF and both are the end of a line, as programs write $R$L, $N or $L.
std::string withLineEnds(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool both = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if (text[i] == '\r' || text[i] == '\n')
      out += "\r\n";
    else
      out += text[i];
    if (both) ++i;
  }
  return out;
}

std::string listOf(const std::vector<std::string>& addresses) {
  std::string list;
  for (const std::string& one : addresses) list += (list.empty() ? "" : ",\r\n ") + one;
  return list;
}

}  // namespace

Letter letterOf(const system::MailData& mail, const std::string& sender, std::string_view date) {
  const std::string text = withLineEnds(toUtf8(mail.text, Encoding::Cp1252));
  const bool plain = isPlainText(text);
  // A line end in the subject would be the end of its header.
  const std::string subject = escaped(toUtf8(mail.subject, Encoding::Cp1252), Escape::None);
  Letter letter{mail.from.empty() ? sender : mail.from, mail.to, {}};
  letter.content = fmt::format(
      "Date: {}\r\nFrom: {}\r\nTo: {}\r\nSubject: {}\r\nMIME-Version: 1.0\r\n"
      "Content-Type: text/plain; charset=utf-8\r\nContent-Transfer-Encoding: {}\r\n\r\n{}\r\n",
      date, letter.from, listOf(letter.to), encodedWords(subject),
      plain ? "7bit" : "quoted-printable", plain ? text : quotedPrintable(text));
  return letter;
}

}  // namespace merker::itcp
