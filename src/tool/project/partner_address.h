// Where the partner of a configured connection is: "tcp://127.0.0.1:10102".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace merker::project {

struct PartnerAddress {
  std::string host;                     // a number: who is asked for names is no business of a PLC
  std::optional<std::uint16_t> port{};  // 1 …
};
// Nothing: it is none. `scheme`: "tcp" or "udp".
std::optional<PartnerAddress> partnerAddress(std::string_view text, std::string_view scheme);

// All of `text`, in this base, from 0 to `most`.
std::optional<std::uint32_t> wholeNumber(std::string_view text, int base, std::uint32_t most);
// The text up to `end`, taken off; all of it without one.
std::string_view upTo(std::string_view& text, char end);

}  // namespace merker::project
