// What could not be read of a project; whoever shows it has the sentences.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace merker::s7p {

enum class FaultKind : std::uint8_t {
  NoTable,    // the file is no dBase table
  CutTable,   // rows are missing that its header counts
  LongTable,  // more rows than are read
  NoMemo,     // the memo file of a block folder is missing or cut off
  NoLinks,    // linkhrs.lnk is missing or has no page of the program
  NoCode,     // a block without code
  WrongChecksum,
  WrongInterface,  // the binary interface cannot be read
  TwiceInFolder,   // another row with the same number, which is not linked
  UnknownPage,     // no language file: code page 1252 is assumed
  WidePage,        // several bytes a character
  WrongNumber      // of a block
};

struct Fault {
  FaultKind kind;
  std::string where, what;  // a path, a block or program
};
using Faults = std::vector<Fault>;

}  // namespace merker::s7p
