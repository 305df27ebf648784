#include "system/mail_data.h"

#include <algorithm>

#include "base/mail_address.h"
#include "base/text.h"

namespace merker::system {
namespace {

using View = std::span<const std::uint8_t>;

constexpr std::size_t kStringHead = 2;    // longest and present length (S7-TYPES-19)
constexpr std::size_t kLeastStrings = 4;  // addressees, sender, subject, text

// The next STRING, taken off; each begins at an even byte. Nothing: there is none, or it is wrong.
std::optional<std::string> nextString(View& rest) {
  if (rest.size() < kStringHead) return std::nullopt;
  const std::size_t longest = rest[0], length = rest[1];
  if (length > longest || kStringHead + length > rest.size()) return std::nullopt;
  const View characters = rest.subspan(kStringHead, length);
  rest = rest.subspan(std::min(rest.size(), (kStringHead + longest + 1) / 2 * 2));
  return std::string(characters.begin(), characters.end());
}

std::vector<std::string> addresses(std::string_view list) {
  std::vector<std::string> found;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find_first_of(";,"), list.size());
    if (const auto one = trim(list.substr(0, end)); !one.empty()) found.emplace_back(one);
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return found;
}

bool isGood(const MailData& mail) {
  const bool one = !mail.to.empty() && mail.to.size() <= MailData::kMostAddressees;
  return one && std::ranges::all_of(mail.to, isMailAddress) &&
         (mail.from.empty() || isMailAddress(mail.from));
}

}  // namespace

std::optional<MailData> mailOf(View bytes) {
  std::vector<std::string> strings;
  while (bytes.size() >= kStringHead) {
    auto one = nextString(bytes);
    if (!one) return std::nullopt;
    strings.push_back(std::move(*one));
  }
  if (strings.size() < kLeastStrings) return std::nullopt;
  MailData mail{addresses(strings[0]), std::string(trim(strings[1])), strings[2], {}};
  for (std::size_t i = kLeastStrings - 1; i < strings.size(); ++i) mail.text += strings[i];
  return isGood(mail) ? std::optional(std::move(mail)) : std::nullopt;
}

}  // namespace merker::system
