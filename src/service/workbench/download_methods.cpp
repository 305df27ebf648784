// The project as a zip: written beside the PLC, fetched piece by piece.
#include "workbench/base64.h"
#include "workbench/elsewhere.h"
#include "workbench/packing.h"

namespace merker::workbench {
namespace download_methods {
namespace {

constexpr std::size_t kPiece = 1 << 20;

Answer begin(const Call& call) {
  call.browser.download = nullptr;
  return elsewhere<Packing>(
      call, call.shared.helper,
      [](const Aside& aside) { return pack(aside.folder, choose(aside.folder), aside.stop); },
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
