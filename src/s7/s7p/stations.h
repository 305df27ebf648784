// Stations and their modules, by name: hOmSave7 (docs/formats/s7p.md).
#pragma once

#include <map>
#include <string>

#include "archive/tree.h"
#include "base/code_page.h"

namespace merker::s7p {

struct Program;

class Stations {
 public:
  Stations(const archive::Tree& tree, const std::string& project, const CodePage& page);
  // Station and CPU of the program that belongs to this module.
  void fill(std::uint32_t moduleType, std::uint32_t module, Program& program) const;

 private:
  struct Object {
    std::uint32_t parentType = 0, parent = 0;
    std::string name;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Object> objects_;  // by type and number
};

}  // namespace merker::s7p
