// The project as a zip: written beside the PLC, fetched piece by piece.
#include "archive/zip_writer.h"
#include "project/files.h"
#include "workbench/base64.h"
#include "workbench/elsewhere.h"

namespace merker::workbench {
namespace download_methods {
namespace {

constexpr std::uint64_t kMega = 1 << 20, kLargestProject = 256 * kMega;
constexpr std::size_t kPiece = 1 << 20;

// What belongs to this computer and not to the project: a memory card that is in use, copies that
// editors make.
bool isLeft(const std::string& path) {
  constexpr std::string_view kEndings[] = {
      ".sqlite", ".sqlite-wal", ".sqlite-shm", ".sqlite-journal", ".tmp", ".bak", "~"};
  return std::ranges::any_of(kEndings,
                             [&](std::string_view ending) { return path.ends_with(ending); });
}

constexpr std::int64_t kSecond = 1'000'000'000;  // ns

std::vector<archive::Packed> packedFiles(const ProjectFolder& folder, Json& left) {
  std::vector<archive::Packed> files;
  for (const auto& [path, stamp] : folder.list(project::kMostEntries)) {
    if (isLeft(path))
      left.push_back(path);
    else
      files.push_back({path, stamp.size, stamp.changed / kSecond,
                       [&folder, name = path] { return folder.file(name); }});
  }
  return files;
}

// Null: it was written.
std::optional<Problems> wrong(const archive::Zipped& zip) {
  using archive::ZipFailure;
  switch (zip.failure) {
    case ZipFailure::None:
      return std::nullopt;
    case ZipFailure::TooLarge:
      return refused(ProblemCode::P1308, "the project cannot be packed",
                     fmt::format("it has more than {} MB", kLargestProject / kMega));
    case ZipFailure::Unreadable:
      return refused(ProblemCode::P1310, zip.path);
    case ZipFailure::Unwritable:
      return refused(ProblemCode::P1313, "the zip", "the temporary folder is full or missing");
    case ZipFailure::Stopped:
      return refused(ProblemCode::P1308, "the project cannot be packed", "it was cancelled");
  }
  return std::nullopt;
}

std::string zipName(const ProjectFolder& folder) {
  const std::string stem = project::stemOf(folder.folder());
  return (stem.empty() || stem == "." ? "project" : stem) + ".zip";
}

struct Packing {
  std::optional<Problems> wrong;
  std::shared_ptr<const archive::File> file;
  Json result;
};

Packing packed(const Aside& aside) {
  Json left = Json::array();
  const auto files = packedFiles(aside.folder, left);
  archive::Zipped zip = archive::writeZip(files, kLargestProject, aside.stop);
  Packing packing{wrong(zip), nullptr, {}};
  if (packing.wrong) return packing;
  packing.result = {{"name", zipName(aside.folder)},
                    {"size", zip.file->size()},
                    {"files", files.size()},
                    {"left", std::move(left)}};
  packing.file = std::move(zip.file);
  return packing;
}

Answer begin(const Call& call) {
  call.browser.download = nullptr;
  return elsewhere<Packing>(call, call.shared.helper, packed,
                            [](const Call& now, Packing& made) -> Answer {
                              if (made.wrong) return *made.wrong;
                              now.browser.download = std::move(made.file);
                              return std::move(made.result);
                            });
}

Answer piece(const Call& call) {
  constexpr std::int64_t kLast = 1ll << 53;
  const auto at = static_cast<std::uint64_t>(call.fields.integer("at", 0, kLast));
  if (!call.fields.good()) return call.fields.problems();
  if (!call.browser.download)
    return refused(ProblemCode::P1308, "there is nothing to fetch", "download.begin comes first");
  return elsewhere(call, call.shared.clerk,
                   [file = call.browser.download, at](const Aside&) -> Answer {
                     std::vector<std::uint8_t> bytes(kPiece);
                     bytes.resize(file->read(at, bytes));
                     return Json{{"data", toBase64(bytes)}};
                   });
}

Answer end(const Call& call) {
  call.shared.discard(std::exchange(call.browser.download, nullptr));
  return empty();
}

constexpr Method kMethods[] = {
    {"download.begin", Needs::Plc, begin, Kind::Compiles},
    {"download.piece", Needs::Nothing, piece},
    {"download.end", Needs::Nothing, end},
};

}  // namespace
}  // namespace download_methods

std::span<const Method> downloadMethods() { return download_methods::kMethods; }

}  // namespace merker::workbench
