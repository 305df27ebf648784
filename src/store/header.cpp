#include "store/header.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "base/bytes.h"

namespace merker::store {
namespace {

// Database file format of SQLite, section 1.3.
constexpr std::string_view kMagic{"SQLite format 3", 16};
constexpr std::size_t kHeader = 100, kApplicationIdAt = 68;

}  // namespace

std::string whyNoCard(const std::string& file) {
  // Its creation was cut off; SQLite brings it back to nothing.
  if (std::filesystem::exists(file + "-journal")) return {};
  std::ifstream in(file, std::ios::binary);
  std::array<char, kHeader> header{};
  in.read(header.data(), kHeader);
  if (in.gcount() == 0) return {};
  if (in.gcount() < static_cast<std::streamsize>(kHeader) ||
      std::string_view(header.data(), kMagic.size()) != kMagic)
    return "card.sqlite in it is no database";
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(header.data());
  if (loadDWord(bytes + kApplicationIdAt) != kApplicationId)
    return "card.sqlite in it is the database of another program";
  return {};
}

}  // namespace merker::store
