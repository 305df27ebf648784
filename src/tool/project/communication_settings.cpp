// [communication] of merker.toml: connections of the CPU and its S7 server.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "project/readers.h"

namespace merker::project {
namespace {

constexpr std::uint32_t kMostConnections = 64;  // that a project can set; more: "unlimited"
constexpr std::uint32_t kLeastPdu = 112, kMostPdu = 960;

// `connections`: at most as many as the CPU has; "unlimited" is for laboratories.
void readConnections(const Table& table, CommunicationParameters& parameters) {
  const auto* const node = table.node("connections");
  if (node == nullptr) return;
  const std::uint32_t most = parameters.connections.value_or(kMostConnections);
  if (node->is_integer()) {
    parameters.connections = table.number("connections", 1, most).value_or(most);
    return;
  }
  const auto* const word = node->as_string();
  if (word != nullptr && word->get() == "unlimited")
    parameters.connections.reset();
  else
    table.mustBe("connections", fmt::format("a whole number from 1 to {} or \"unlimited\"", most));
}

// What is kept for each kind of partner must be there.
void readReserved(const Table& table, std::uint32_t basicAtMost,
                  CommunicationParameters& parameters) {
  const std::uint32_t all = parameters.connections.value_or(kMostConnections);
  // LIM-05: one is always kept for a programming device, and one for a panel; a laboratory decides
  // itself.
  const std::uint32_t least = parameters.connections && all > 1 ? 1 : 0;
  parameters.pg = table.number("pg", least, all).value_or(std::min(parameters.pg, all));
  const std::uint32_t rest = all - std::min(parameters.pg, all);  // of a single one: none
  parameters.op = table.number("op", least, all).value_or(std::min(parameters.op, rest));
  parameters.basic = table.number("basic", 0, basicAtMost).value_or(parameters.basic);
  if (parameters.pg + parameters.op + parameters.basic > all)
    table.mustBe("pg",
                 fmt::format("with op and basic at most the {} connections that there are", all));
}

bool isPort(std::string_view text) {
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  return !text.empty() && error == std::errc() && end == text.data() + text.size();
}

// A file opens nothing to other computers: only who starts the program does (--s7).
bool isOfThisComputer(std::string_view place) {
  const std::size_t colon = place.rfind(':');
  if (colon == std::string_view::npos) return isPort(place);
  const std::string_view host = place.substr(0, colon);
  return isPort(place.substr(colon + 1)) &&
         (host == "127.0.0.1" || host == "[::1]" || host == "localhost");
}

void readAddress(const Table& table, CommunicationParameters& parameters) {
  constexpr std::string_view kWhat =
      "a port of this computer like \"127.0.0.1:10102\"; others need --s7";
  const auto address = table.text("address", kWhat);
  if (!address) return;
  if (isOfThisComputer(*address))
    parameters.address = *address;
  else
    table.mustBe("address", kWhat);
}

constexpr std::array<std::string_view, 7> kKeys{"connections", "pg",          "op",     "basic",
                                                "pdu",         "strict_slot", "address"};
constexpr std::array<std::string_view, 2> kProtection{"protection", "password"};

}  // namespace

CommunicationParameters readCommunication(const Table& root, const CpuModel& model,
                                          bool hasProtection) {
  CommunicationParameters parameters = CommunicationParameters::of(model);
  const auto table = root.table("communication");
  if (!table) return parameters;
  std::vector<std::string_view> known{kKeys.begin(), kKeys.end()};
  if (hasProtection) known.insert(known.end(), kProtection.begin(), kProtection.end());
  table->allow(known);
  readConnections(*table, parameters);
  readReserved(*table, connectionLimits(model).basic, parameters);
  if (const auto pdu = table->number("pdu", kLeastPdu, kMostPdu, "(bytes)"))
    parameters.pdu = static_cast<std::uint16_t>(*pdu);
  parameters.strictSlot = table->flag("strict_slot").value_or(false);
  readAddress(*table, parameters);
  return parameters;
}

// They are parameters of the CPU; whoever looks for them among those of the connections finds them.
void readCommunicationProtection(const Table& root, CpuParameters& parameters) {
  const auto table = root.table("communication"), cpu = root.table("cpu");
  if (!table) return;
  for (const std::string_view key : kProtection)
    if (table->has(key) && cpu && cpu->has(key))
      return table->mustBe(key, "here or in [cpu], not in both");
  if (table->has("protection") || table->has("password")) readProtection(*table, parameters);
}

}  // namespace merker::project
