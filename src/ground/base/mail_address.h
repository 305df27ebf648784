// Addresses of e-mails.
#pragma once

#include <string_view>

namespace merker {

// name@domain of printable ASCII without what has a meaning in a header or a command of SMTP: as
// much of RFC 5321, 4.1.2 as machines need.
bool isMailAddress(std::string_view text);

}  // namespace merker
