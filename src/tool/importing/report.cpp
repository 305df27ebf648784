#include "importing/report.h"

#include <fmt/args.h>

#include "base/visible.h"

namespace merker::importing {
namespace {

struct Row {
  Effect effect;
  std::string_view text;
};
constexpr Row kRows[] = {
#define NOTE(id, effect, text) {Effect::effect, text},
#include "importing/notes.inc"
#undef NOTE
};

constexpr std::size_t kMostLines = 20'000;

std::string_view reason(archive::Refusal why) {
  using archive::Refusal;
  switch (why) {
    case Refusal::Unreadable:
      return "it cannot be read";
    case Refusal::Link:
      return "links are not followed";
    case Refusal::LeadsOut:
      return "its path leads out of the archive";
    case Refusal::TooMany:
      return "there are too many files; this one and the following are left out";
    case Refusal::TooLarge:
      return "it is too large when unpacked";
    case Refusal::TooDense:
      return "it is packed more densely than real files are";
    case Refusal::TooDeep:
      return "it lies too deep in folders or archives";
    case Refusal::Packing:
      return "its packing method is not supported; pack it again with Deflate";
    case Refusal::Encrypted:
      return "it is encrypted";
    case Refusal::BadName:
      return "its name has control characters or is not valid UTF-8; rename it";
    case Refusal::Damaged:
      return "it is damaged or cut off; what lies before was read";
  }
  return "";
}

}  // namespace

void Report::addText(Note note, const std::vector<std::string>& arguments) {
  const Row& row = kRows[static_cast<std::size_t>(note)];
  ++counts_[static_cast<std::size_t>(row.effect)];
  lost_ |= row.effect == Effect::Lost;
  if (lines_.size() >= kMostLines) return;
  fmt::dynamic_format_arg_store<fmt::format_context> store;
  // Names come from outside: control characters must reach neither a terminal nor the file.
  for (const std::string& argument : arguments) store.push_back(visible(argument));
  lines_.push_back({row.effect, fmt::vformat(row.text, store),
                    note == Note::Listing ? arguments.front() : std::string()});
}

void Report::add(const s7p::Fault& fault) {
  using s7p::FaultKind;
  switch (fault.kind) {
    case FaultKind::NoTable:
      return add(Note::NoTable, fault.where);
    case FaultKind::CutTable:
      return add(Note::CutTable, fault.where, fault.what);
    case FaultKind::LongTable:
      return add(Note::LongTable, fault.where, fault.what);
    case FaultKind::NoMemo:
      return add(Note::NoMemo, fault.where);
    case FaultKind::NoLinks:
      return add(Note::NoLinks, fault.what);
    case FaultKind::NoCode:
      return add(Note::NoCode, fault.what);
    case FaultKind::WrongChecksum:
      return add(Note::ZeroChecksum, fault.what);
    case FaultKind::WrongInterface:
      return add(Note::WrongInterface, fault.what);
    case FaultKind::TwiceInFolder:
      return add(Note::TwiceInFolder, fault.what);
    case FaultKind::UnknownPage:
      return add(Note::UnknownPage, fault.what);
    case FaultKind::WidePage:
      return add(Note::WidePage, fault.what);
    case FaultKind::WrongNumber:
      return add(Note::WrongNumber, fault.where, fault.what);
  }
}

void Report::add(const archive::Refused& refused) {
  add(Note::Refused, refused.path, reason(refused.why));
}

std::size_t Report::count(Effect effect) const { return counts_[static_cast<std::size_t>(effect)]; }

std::string Report::text() const {
  static constexpr std::string_view kTitles[] = {"Imported", "In another form", "Not imported",
                                                 "Beside it, not part of a program"};
  std::string out;
  for (const Effect effect : {Effect::Info, Effect::Changed, Effect::Lost, Effect::Beside}) {
    if (count(effect) == 0) continue;
    out +=
        fmt::format("{}{}:\n", out.empty() ? "" : "\n", kTitles[static_cast<std::size_t>(effect)]);
    std::size_t shown = 0;
    for (const Line& line : lines_) {
      if (line.effect != effect) continue;
      out += fmt::format("  {}\n", line.text);
      ++shown;
    }
    if (shown < count(effect)) out += fmt::format("  and {} more\n", count(effect) - shown);
  }
  return out;
}

std::vector<std::string> reasons(const archive::Tree& tree) {
  Report refused;
  for (const archive::Refused& one : tree.refused()) refused.add(one);
  std::vector<std::string> texts;
  for (const Report::Line& line : refused.lines()) texts.push_back(line.text);
  return texts;
}

}  // namespace merker::importing
