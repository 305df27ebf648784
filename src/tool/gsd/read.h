// Reads a GSD file of any maker and language (.gsd, .gse, .gsg, …). What is wrong in it is remarked
// and read as it must be meant; no module is lost.
#pragma once

#include <vector>

#include "gsd/device.h"
#include "gsd/statement.h"

namespace merker::gsd {

// Bytes; the largest that makers publish have half of it.
constexpr std::size_t kLargestFile = 1024 * 1024;

struct Reading {
  bool isGsd = false;  // else nothing in it says so
  Device device;
  std::vector<Remark> remarks;  // by their lines
};

Reading read(const source::SourceFile& file);

// The text of a file: CP1252 as the standard wants it, or whatever else it obviously is.
source::SourceFile decode(std::string name, std::string bytes);

}  // namespace merker::gsd
