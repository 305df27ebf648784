#include "softplc/stack_fields.h"

#include <fmt/format.h>

#include <array>
#include <charconv>

#include "base/text.h"

namespace merker::sinumerik {
namespace {

using Stack = InterruptStack;

std::string hexWord(std::uint32_t value) { return fmt::format("{:04X}", value); }
std::string akkuText(std::uint32_t value) {
  return fmt::format("{:04X} {:04X}", value >> 16, value & 0xFFFF);
}
std::string idText(const std::optional<mc5::BlockId>& id) { return id ? toString(*id) : "-"; }
std::string dbText(const std::optional<std::uint16_t>& number) {
  return number ? fmt::format("DB {}", *number) : "-";
}

struct ScreenField {
  std::string_view name;
  std::string (*text)(const Stack&);
};
constexpr std::array kFields{
    ScreenField{"TIEFE", [](const Stack& s) { return fmt::format("{:02}", s.depth); }},
    ScreenField{"BEF-REG", [](const Stack& s) { return hexWord(s.instruction); }},
    ScreenField{"SAZ", [](const Stack& s) { return hexWord(s.stepAddress); }},
    ScreenField{"DB-ADR", [](const Stack& s) { return hexWord(s.dataAddress); }},
    ScreenField{"BA-ADR", [](const Stack& s) { return hexWord(s.blockAddress); }},
    ScreenField{"BST-STP", [](const Stack& s) { return hexWord(s.blockStackPointer); }},
    ScreenField{"XX-NR", [](const Stack& s) { return idText(s.block); }},
    ScreenField{"DB-NR", [](const Stack& s) { return dbText(s.dataBlock); }},
    ScreenField{"YY-NR", [](const Stack& s) { return idText(s.caller); }},
    ScreenField{"REL-SAZ", [](const Stack& s) { return hexWord(s.relativeStep); }},
    ScreenField{"DBL-REG", [](const Stack& s) { return hexWord(s.dataLength); }},
    ScreenField{"VEK-ADR", [](const Stack&) { return hexWord(0); }},
    ScreenField{"UAMK", [](const Stack& s) { return hexWord(s.controlRegister); }},
    ScreenField{"AKKU1", [](const Stack& s) { return akkuText(s.akku1); }},
    ScreenField{"AKKU2", [](const Stack& s) { return akkuText(s.akku2); }}};

// Bit 0 first (S5-STAT-01).
constexpr std::array<std::string_view, 8> kDisplayNames{"ERAB",  "VKE",  "STATUS", "ODER",
                                                        "OVFLS", "OVFL", "ANZ0",   "ANZ1"};

struct FineField {
  std::string_view name, address;
  std::uint16_t (*value)(const FineCode&);
};
constexpr std::array kFineFields{
    FineField{"FEHLCODE", "F000", [](const FineCode& c) { return c.code; }},
    FineField{"ALARM", "F001", [](const FineCode& c) { return c.number; }},
    FineField{"XXX1", "F002", [](const FineCode& c) { return c.words[0]; }},
    FineField{"XXX2", "F003", [](const FineCode& c) { return c.words[1]; }},
    FineField{"XXX3", "F004", [](const FineCode& c) { return c.words[2]; }},
    FineField{"ZOB2", "F005", [](const FineCode& c) { return c.delays; }}};

// "XX-NR." of the screen is XX-NR.
std::string plainName(std::string_view text) {
  std::string result = upper(trim(text));
  while (result.ends_with('.') || result.ends_with(':')) result.pop_back();
  return result;
}

std::string bitText(bool on) { return on ? "1" : "0"; }

template <typename Call>
void eachCause(Call call) {
  for (auto cause = Cause::STOPS; cause <= Cause::TRAF;
       cause = static_cast<Cause>(static_cast<int>(cause) + 1))
    call(cause);
}

std::optional<std::string> bitField(const OperatingSystem& os, const std::string& wanted) {
  const Stack& stack = os.record().picture().interrupt;
  std::optional<std::string> result;
  for (std::size_t i = 0; i < kDisplayNames.size(); ++i)
    if (wanted == kDisplayNames[i]) result = bitText((stack.displays >> i & 1) != 0);
  eachCause([&](Cause cause) {
    if (wanted == name(cause)) result = bitText(stack.causes.test(cause));
  });
  for (const ControlBitRow& row : controlBitRows())
    if (wanted == row.name) result = bitText(os.controlBits().test(row.id));
  return result;
}

// "12 ADR": the number and what follows.
struct EntryName {
  std::size_t number = 0;
  std::string column;
};

std::optional<EntryName> entryNameOf(const std::string& text) {
  EntryName entry;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), entry.number);
  if (error != std::errc() || entry.number == 0) return std::nullopt;
  entry.column =
      std::string(trim(std::string_view(text).substr(static_cast<std::size_t>(end - text.data()))));
  return entry;
}

}  // namespace

std::optional<std::string> interruptField(const OperatingSystem& os, std::string_view name) {
  const std::string wanted = plainName(name);
  for (const ScreenField& field : kFields)
    if (wanted == field.name) return field.text(os.record().picture().interrupt);
  for (const FineField& field : kFineFields)
    if (wanted == field.name || wanted == field.address)
      return hexWord(field.value(os.record().fineCode()));
  return bitField(os, wanted);
}

std::string interruptFields() {
  std::string list;
  const auto add = [&list](std::string_view name) {
    list.append(list.empty() ? "" : " ").append(name);
  };
  for (const ScreenField& field : kFields) add(field.name);
  for (std::size_t i = kDisplayNames.size(); i-- > 0;) add(kDisplayNames[i]);
  eachCause([&](Cause cause) { add(name(cause)); });
  for (const FineField& field : kFineFields) add(field.name);
  for (const ControlBitRow& row : controlBitRows()) add(row.name);
  return list;
}

std::optional<std::string> blockField(const OperatingSystem& os, std::string_view name) {
  const std::vector<BlockStackEntry>& stack = os.record().picture().blocks;
  const std::string wanted = plainName(name);
  if (wanted == "ENTRIES") return std::to_string(stack.size());
  const auto entry = entryNameOf(wanted);
  if (!entry) return std::nullopt;
  const bool there = entry->number <= stack.size();
  const BlockStackEntry shown = there ? stack[entry->number - 1] : BlockStackEntry{};
  if (entry->column.empty()) return there ? toString(shown.block) : "-";
  if (entry->column == "ADR") return there ? hexWord(shown.returnAddress) : "-";
  if (entry->column == "REL") return there ? hexWord(shown.relative) : "-";
  if (entry->column == "DB") return dbText(shown.dataBlock);
  return std::nullopt;
}

std::string blockFields() { return "1, 1 ADR, 1 REL, 1 DB (1 = innermost), 2 …, ENTRIES"; }

std::string stopLine(const OperatingSystem& os) {
  const Stack& s = os.record().picture().interrupt;
  return fmt::format(
      "FEHLCODE {}, BEF-REG {}, SAZ {}, XX-NR {}, REL-SAZ {}, YY-NR {}, DB-NR {}, AKKU1 {}, "
      "AKKU2 {}, ANZ1 ANZ0 OVFL OVFLS ODER STATUS VKE ERAB {:08b}",
      hexWord(os.record().fineCode().code), hexWord(s.instruction), hexWord(s.stepAddress),
      idText(s.block), hexWord(s.relativeStep), idText(s.caller), dbText(s.dataBlock),
      akkuText(s.akku1), akkuText(s.akku2), s.displays);
}

}  // namespace merker::sinumerik
