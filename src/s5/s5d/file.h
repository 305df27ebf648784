// The blocks of an S5D file as bytes: found by its directories and by looking at every record.
#pragma once

#include <string>
#include <vector>

#include "s5d/kind.h"

namespace merker::s5d {

// A view into the file.
struct Record {
  const Kind* kind = nullptr;  // null: unknown
  std::uint8_t number = 0;
  std::size_t offset = 0;  // bytes from the beginning of the file
  Bytes bytes;
  bool cut = false;          // the file ends before the block
  std::string name() const;  // "PB 5"; "record 17" if it is unknown
};

struct File {
  std::string name;               // eight characters, without blanks at the end
  std::vector<Record> records;    // in the order of the file
  std::vector<Record> deleted;    // found by their marks alone, no directory has them
  std::size_t badSections = 0;    // entries of the directory that lead nowhere
  bool withoutDirectory = false;  // no directory is of use; all records were found by their marks
};

constexpr std::size_t kLargestFile = 65535 * kRecord;  // a record number has 16 bits

// Whether it has a sound block of code or data, by its directory or behind its mark.
bool isS5d(Bytes file);
// Takes any bytes; more than kLargestFile are not looked at.
File readFile(Bytes file);

}  // namespace merker::s5d
