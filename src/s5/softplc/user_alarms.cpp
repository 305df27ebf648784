#include "softplc/user_alarms.h"

#include <fmt/format.h>

namespace merker::sinumerik {
namespace {

constexpr unsigned kBits = 64, kAlarms = 6000, kMessages = 7000;

bool dataBit(const Machine& m, const BitField& field, unsigned index) {
  const Entry& entry = m.blocks.find({mc5::BlockType::Db, field.db});
  const std::uint64_t word = std::uint64_t{field.first} + index / 16;
  return entry.present && word < entry.length &&
         (m.blocks.data()[entry.start + word] >> index % 16 & 1) != 0;
}

bool isSet(const Machine& m, const BitField& field, unsigned index) {
  if (field.db != 0) return dataBit(m, field, index);
  const std::size_t byte = field.first + index / 8;
  return byte < m.flags.size() && (m.flags[byte] >> index % 8 & 1) != 0;
}

void show(const std::optional<BitField>& field, unsigned first, std::string_view kind,
          const UserAlarms& configured, const Machine& m, AlarmList& list) {
  if (!field) return;
  for (unsigned i = 0; i < kBits; ++i) {
    const unsigned number = first + i;
    if (!isSet(m, *field, i)) {
      list.withdraw(number);
      continue;
    }
    if (list.pending(number)) continue;
    const auto text = configured.texts.find(number);
    list.announce(
        number, fmt::format("{} {}", number, text == configured.texts.end() ? kind : text->second),
        m.clock, false);
  }
}

}  // namespace

void showUserAlarms(const UserAlarms& configured, const Machine& m, AlarmList& list) {
  show(configured.alarms, kAlarms, "Anwenderalarm", configured, m, list);
  show(configured.messages, kMessages, "PLC-Anwenderbetriebsmeldung", configured, m, list);
}

}  // namespace merker::sinumerik
