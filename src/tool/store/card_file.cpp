#include "store/card_file.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "base/bytes.h"

namespace merker::store {
namespace {

namespace fs = std::filesystem;

// Database file format of SQLite, section 1.3.
constexpr std::string_view kMagic{"SQLite format 3", 16};
constexpr std::size_t kHeader = 100, kApplicationIdAt = 68;
// A card that is just being made has a dozen pages.
constexpr std::uintmax_t kLargestNew = 256 * 1024;

// A pipe would wait for a writer, a device may have no end, a link may lead anywhere.
std::string whyNoFile(const std::string& file, std::uintmax_t largest) {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(file, error);
  const std::string name = fs::path(file).filename().string();
  if (!fs::exists(status)) return {};
  if (!fs::is_regular_file(status)) return name + " in it is not a regular file";
  if (fs::file_size(file, error) > largest || error)
    return fmt::format("{} in it is longer than {} kB", name, largest / 1024);
  return {};
}

std::uintmax_t length(const std::string& file) {
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(file, error);
  return error ? 0 : bytes;
}

std::string whyForeign(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::array<char, kHeader> header{};
  in.read(header.data(), kHeader);
  if (in.gcount() == 0) return {};
  if (in.gcount() < static_cast<std::streamsize>(kHeader) ||
      std::string_view(header.data(), kMagic.size()) != kMagic)
    return "card.sqlite in it is not a database";
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(header.data());
  if (loadDWord(bytes + kApplicationIdAt) != kApplicationId)
    return "card.sqlite in it is the database of another program";
  return {};
}

}  // namespace

std::optional<Problem> whyNoCard(const std::string& file, const Position& at) {
  const std::uintmax_t largest = hasJournal(file) ? kLargestNew : kLargestCard;
  for (const char* part : {"", "-journal", "-wal", "-shm"})
    if (const std::string why = whyNoFile(file + part, largest); !why.empty())
      return makeProblem(ProblemCode::P1003, at, why);
  // SQLite would delete the log.
  if (length(file) == 0 && length(file + "-wal") > 0)
    return makeProblem(ProblemCode::P1003, at, "card.sqlite in it is empty, its log is not");
  // Not yet written if its creation was cut off.
  if (hasJournal(file)) return std::nullopt;
  if (const std::string why = whyForeign(file); !why.empty())
    return makeProblem(ProblemCode::P1002, at, why);
  return std::nullopt;
}

bool hasJournal(const std::string& file) {
  std::error_code error;
  return fs::exists(fs::symlink_status(file + "-journal", error));
}

NewLog::NewLog(const std::string& file) : log_(file + "-wal"), isNew_(!fs::exists(log_)) {}

NewLog::~NewLog() {
  std::error_code error;
  if (isNew_ && fs::file_size(log_, error) == 0 && !error) fs::remove(log_, error);
}

}  // namespace merker::store
