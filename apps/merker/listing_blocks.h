// Blocks of a SINUMERIK program for `merker list`.
#pragma once

#include <nlohmann/json.hpp>

#include "build.h"

namespace merker::app {

struct ListingOptions {
  bool code = false;     // each block disassembled, with its machine code
  bool text = false;     // the program as a listing
  bool symbols = false;  // in it symbols where operands have them
};

void printListings(const Build& build, const ListingOptions& options);
nlohmann::json listingsToJson(const Build& build, const ListingOptions& options);

}  // namespace merker::app
