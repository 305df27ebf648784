// Changes of a merker.toml as the hardware view makes them (S7-HWCFG-01 to -03, -08, -09). Only
// what is changed is written anew: comments, order and blanks of the user's file stay.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/problem.h"

namespace merker::project {

struct ModulePlace {
  std::uint32_t rack = 0;
  std::string slot;  // "4", "2.2"
  bool operator==(const ModulePlace&) const = default;
};

// The lines of a module with its channels: from its header to behind the last one.
struct ModuleLines {
  std::uint32_t first = 0, behind = 0;
  ModulePlace place;
};

class SettingsEdit {
 public:
  // Value of a key as TOML, `"4..20mA"`; none: the key is taken out.
  using Value = std::optional<std::string>;

  SettingsEdit(std::string file, std::string text);

  const std::string& text() const { return text_; }
  // P0702 where the text is no TOML, P1308 where modules are not written as [[module]]: nothing can
  // be changed then.
  const std::optional<Problem>& problem() const { return problem_; }

  bool has(const ModulePlace& place) const;
  // `type` is empty on board of the CPU.
  void add(const ModulePlace& place, std::string_view type);
  // With the comment right above it.
  void remove(const ModulePlace& place);
  void move(const ModulePlace& place, const ModulePlace& to);
  // "serial.baud" is a key of [module.serial].
  void set(const ModulePlace& place, std::string_view key, const Value& value);
  // A [[module.channel]] that `side` ("input", "output", "number") and its number name.
  void setChannel(const ModulePlace& place, std::string_view side, std::uint32_t number,
                  std::string_view key, const Value& value);
  // What such a table holds, `side` among it; empty: there is none.
  std::vector<std::string> channelKeys(const ModulePlace& place, std::string_view side,
                                       std::uint32_t number) const;
  // Of a table with a name: "cpu", "cpu.OB35".
  void setIn(std::string_view table, std::string_view key, const Value& value);

  // A [[plant]] behind everything else; all values as TOML.
  using Pairs = std::vector<std::pair<std::string, std::string>>;
  void addPlant(std::string_view name, std::string_view kind, const Pairs& parameters,
                const Pairs& wires);

  // A [[title]] behind everything else; all values as TOML.
  void addTable(std::string_view title, const Pairs& values);

  // Files that [program] lists by name: another name, or none. A file that a pattern found and that
  // none would find under its new name is added.
  void renameFile(std::string_view from, std::string_view to);
  void removeFile(std::string_view path);
  // A new file: where [program] lists files of its kind and none finds it, it is added. True: it
  // was.
  bool addFile(std::string_view path);

  // The modules in the order of their lines.
  std::vector<ModuleLines> modules() const;

 private:
  void take(std::string text);

  std::string file_, text_;
  std::optional<Problem> problem_;
};

}  // namespace merker::project
