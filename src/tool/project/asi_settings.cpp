// slave = [ … ] in the [[module]] of a CP 343-2: what is on its AS-Interface (S7-NET-17).
#include <fmt/format.h>

#include <algorithm>

#include "io/asi.h"
#include "project/readers.h"

namespace merker::project {
namespace {

// "S-7.0": IO code and ID code, each a hexadecimal digit.
void readProfile(const Table& table, io::AsiSlave& slave) {
  constexpr std::string_view kWhat = "a profile like \"S-7.0\": IO code and ID code, 0 to F each";
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  constexpr std::size_t kIoCode = 2, kPoint = 3, kIdCode = 4, kLength = 5;
  const auto text = table.text("profile", kWhat);
  if (!text) return;
  const auto code = text->size() == kLength ? kDigits.find((*text)[kIoCode]) : kDigits.npos;
  const bool good = code != kDigits.npos && text->starts_with("S-") && (*text)[kPoint] == '.' &&
                    kDigits.find((*text)[kIdCode]) != kDigits.npos;
  if (!good) return table.mustBe("profile", kWhat);
  slave.profile = *text;
  slave.ioCode = static_cast<std::uint8_t>(code);
}

}  // namespace

void readAsiSlaves(const Table& table, io::Module& module) {
  if (!table.has("slave")) return;
  if (!io::isAsiMaster(*module.type)) {
    table.problems().add(ProblemCode::P0735, table.placeOf("slave"), module.title(),
                         "AS-i slaves; a CP 343-2 has them");
    return;
  }
  auto slaves = std::make_shared<std::vector<io::AsiSlave>>();
  for (const Table& one : table.tables("slave")) {
    one.allow({"address", "name", "profile"});
    io::AsiSlave slave;
    slave.position = one.place();
    slave.name = one.text("name", "a text").value_or("");
    readProfile(one, slave);
    const auto address = one.number("address", 1, io::kHighestAsiAddress);
    if (!one.has("address")) one.mustBe("address", "an AS-i address, 1 to 31");
    if (!address) continue;
    slave.address = *address;
    if (std::ranges::count(*slaves, slave.address, &io::AsiSlave::address) > 0)
      one.mustBe("address", "another one than those of the slaves above");
    else
      slaves->push_back(std::move(slave));
  }
  module.asi = std::move(slaves);
}

}  // namespace merker::project
