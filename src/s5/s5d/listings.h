// What came out of an S5D file as the listings of a project: one file a block.
#pragma once

#include <string>
#include <vector>

#include "s5d/program.h"
#include "source/symbol_table.h"

namespace merker::s5d {

struct ListingFile {
  std::string path;  // "PB5.s5"; of what cannot be in the program "deleted/PB7.s5.txt"
  std::string text;  // UTF-8
};

struct Listings {
  std::vector<ListingFile> files;
  std::vector<Note> notes;
  std::size_t blocks = 0;  // in the program
};

// Each listing compiles to the words of its block; with symbols if it then does, too. A block whose
// code SINUMERIK 810/820 does not have is kept as a text beside the program, as are deleted ones.
Listings listings(const Contents& contents, const source::SymbolTable& symbols);

}  // namespace merker::s5d
