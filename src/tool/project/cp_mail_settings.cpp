// [[connection]] of merker.toml with kind = "e-mail": the mail server that a CP 343-1 IT gives the
// e-mails of its program (S7-NET-16).
#include <algorithm>

#include "base/mail_address.h"
#include "catalogue/ethernet.h"
#include "project/partner_address.h"
#include "project/readers.h"

namespace merker::project {
namespace {

constexpr std::uint16_t kSmtpPort = 25;  // RFC 5321, 4.5.4.2

bool hasItCp(const Settings& settings) {
  return settings.hardware && std::ranges::any_of(settings.hardware->modules, [](const auto& one) {
           return isItCp(*one.type);
         });
}

bool sendsMail(const Table& table) {
  const toml::node* const kind = table.node("kind");
  return kind != nullptr && kind->is_string() && kind->as_string()->get() == "e-mail";
}

}  // namespace

void readCpMail(const Table& table, CpConnectionParameters& connection) {
  table.allow({"kind", "id", "partner", "sender"});
  constexpr std::string_view kWhat =
      "the address of a mail server like \"smtp://127.0.0.1:25\", without a port 25";
  const auto text = table.text("partner", kWhat);
  const auto there = text ? partnerAddress(*text, "smtp") : std::nullopt;
  if (!there && (text || !table.has("partner"))) table.mustBe("partner", kWhat);
  if (there) connection.host = there->host;
  connection.port = there ? there->port.value_or(kSmtpPort) : kSmtpPort;
  constexpr std::string_view kSender = "the address of the sender like \"press@plant.example\"";
  const auto sender = table.text("sender", kSender);
  if (sender ? !isMailAddress(*sender) : !table.has("sender")) table.mustBe("sender", kSender);
  connection.sender = sender.value_or("");
}

void requireItCp(const Table& root, const Settings& settings) {
  if (hasItCp(settings)) return;
  for (const Table& table : root.tables("connection"))
    if (sendsMail(table))
      return table.mustBe("kind", "another one, or the station needs a CP 343-1 IT ([[module]])");
}

}  // namespace merker::project
