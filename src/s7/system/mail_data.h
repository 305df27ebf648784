// An e-mail as the program gives it to a CP 343-1 IT (S7-NET-16): STRINGs one behind the other, as
// a data block declares them: addressees, sender, subject, then the text in one or more. The layout
// is our own: docs/compatibility.md, "E-mails of a CP 343-1 IT".
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace merker::system {

struct MailData {
  static constexpr std::size_t kMostAddressees = 10;

  std::vector<std::string> to;
  std::string from;           // empty: the one of the connection
  std::string subject, text;  // as the program has them: CP1252
  bool operator==(const MailData&) const = default;
};

// Nothing: these bytes are none.
std::optional<MailData> mailOf(std::span<const std::uint8_t> bytes);

}  // namespace merker::system
