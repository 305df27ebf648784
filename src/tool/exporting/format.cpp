#include "exporting/format.h"

#include <array>
#include <filesystem>

#include "exporting/step5.h"
#include "exporting/step7.h"

namespace merker::exporting {
namespace {

constexpr std::array kFormats{
    Format{".awl", Family::Step7, "AWL source of all blocks, with the symbol table (.sdf)",
           writeAwl},
    Format{".wld", Family::Step7, "all blocks as machine code", writeWld},
    Format{".sdf", Family::Step7, "symbol table", writeSymbolTable},
    Format{".asc", Family::Step7, "symbol table", writeSymbolTable},
    Format{".dif", Family::Step7, "symbol table", writeSymbolTable},
    Format{".seq", Family::Step7, "symbol table", writeSymbolTable},
    Format{".s5d", Family::Step5, "program file, with its assignment list", writeS5d},
    Format{".s5", Family::Step5, "all blocks in one listing; --symbols: with its assignment list",
           writeListing},
    Format{".seq", Family::Step5, "assignment list", writeAssignmentList},
};

}  // namespace

std::span<const Format> formats() { return kFormats; }

const Format* formatOf(std::string_view path, Family family) {
  const std::string extension = std::filesystem::path(path).extension().string();
  for (const Format& format : kFormats)
    if (format.family == family && equalsIgnoreCase(format.extension, extension)) return &format;
  return nullptr;
}

Family familyOf(const compilation::Build& build) {
  return build.isListing() ? Family::Step5 : Family::Step7;
}

std::string extensions(Family family) {
  std::string list;
  for (const Format& format : kFormats)
    if (format.family == family) list += (list.empty() ? "" : ", ") + std::string(format.extension);
  return list;
}

}  // namespace merker::exporting
