// What `merker export` writes: one row for each kind of file.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "compilation/build.h"

namespace merker::exporting {

struct Options {
  Encoding codePage = Encoding::Cp437;  // of STEP 5: Cp437 or Cp850
  unsigned page = 0;                    // of STEP 7; 0: the one that has the characters
  bool symbols = false;                 // a source with symbols instead of absolute operands
};

// A file to be written; its path is that of the user with another end ("Z0.SEQ" beside "ST.S5D").
struct OutputFile {
  std::string path;
  std::string bytes;
};

struct Output {
  std::vector<OutputFile> files;      // the one at the path of the user first
  std::vector<std::string> warnings;  // what is not in them as it is in the program
};

enum class Family : std::uint8_t { Step7, Step5 };

struct Format {
  std::string_view extension;  // of the file, lower case: ".s5d"
  Family family;
  std::string_view what;  // "program file of STEP 5"
  // No files if the program has nothing to write.
  Output (*write)(const compilation::Build& build, const std::string& path, const Options& options);
};

std::span<const Format> formats();
// By the end of the path, of the family of the program; null if there is none.
const Format* formatOf(std::string_view path, Family family);
Family familyOf(const compilation::Build& build);
// ".s5d, .s5, .seq": for a message.
std::string extensions(Family family);

}  // namespace merker::exporting
