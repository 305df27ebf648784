// A program of STEP 5 as the files of a project: what `merker import` makes of xxxxxxST.S5D.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"

namespace merker::s5project {

struct Input {
  std::string name;  // of the S5D file, without its folder
  std::span<const std::uint8_t> program;
  std::optional<std::string> assignments;  // the bytes of xxxxxxZ0.SEQ
  std::vector<std::string> beside;         // names of the other files in its folder
  Encoding codePage = Encoding::Cp437;     // of texts: Cp437 or Cp850
};

struct OutputFile {
  std::string path;  // in the project folder
  std::string text;  // UTF-8
};

struct Note {
  std::string text;  // "PB 5: it does not end with BE"
  bool lost = true;  // false: it came in another form
};

struct Output {
  std::string name;  // of the project
  std::vector<OutputFile> files;
  std::size_t blocks = 0, deleted = 0, comments = 0, symbols = 0;
  std::vector<Note> notes;
  bool usable() const { return blocks > 0; }
};

// merker.toml of a program that came from `file`.
std::string settings(const std::string& name, std::string_view file);
// "PUMPE" of "PUMPE@ST.S5D".
std::string projectName(std::string_view file);
bool recognises(std::span<const std::uint8_t> bytes);
// Whether the file beside `program` is its assignment list: "PUMPE@Z0.SEQ" of "pumpe@ST.S5D".
bool isAssignmentList(std::string_view file, std::string_view program);
Output makeProject(const Input& input);

}  // namespace merker::s5project
