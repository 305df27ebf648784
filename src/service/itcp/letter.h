// An e-mail as it goes to a mail server: envelope, header and text (RFC 5321, RFC 5322).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "system/mail_data.h"

namespace merker::itcp {

struct Letter {
  std::string from;
  std::vector<std::string> to;
  std::string content;  // lines that end with CR LF, header and text
};

// `sender`: of a mail that names none. `date`: as headers have it, of whoever sends it.
Letter letterOf(const system::MailData& mail, const std::string& sender, std::string_view date);

}  // namespace merker::itcp
