#include "workbench/message.h"

#include <algorithm>

namespace merker::workbench {
namespace {

// Before anything is built of it. Brackets and commas inside texts do not count.
struct Extent {
  std::size_t deepest = 0, values = 1;
};

Extent extentOf(std::string_view text) {
  Extent extent;
  std::size_t depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '\\') ++i;
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == '{' || c == '[') extent.deepest = std::max(extent.deepest, ++depth), ++extent.values;
    if ((c == '}' || c == ']') && depth > 0) --depth;
    if (c == ',') ++extent.values;
  }
  return extent;
}

}  // namespace

Result<Json> parseMessage(std::string_view text) {
  const Extent extent = extentOf(text);
  if (extent.deepest > kDeepest) return makeProblem(ProblemCode::P1302, nowhere(), kDeepest);
  if (extent.values > kMostValues)
    return makeProblem(ProblemCode::P1314, nowhere(), kMostValues, "values in a request");
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return makeProblem(ProblemCode::P1301, nowhere());
  return json;
}

Request readRequest(std::string_view message) {
  auto json = parseMessage(message);
  if (!json) return {nullptr, json.error(), message.size()};
  return {std::make_shared<const Json>(std::move(*json)), std::nullopt, message.size()};
}

std::int64_t requestId(const Json& request) {
  constexpr std::uint64_t kExact = 1ull << 53;
  const auto id = request.find("id");
  if (id == request.end() || !id->is_number_unsigned()) return 0;
  const auto number = id->get<std::uint64_t>();
  return number <= kExact ? static_cast<std::int64_t>(number) : 0;
}

void relate(Json& problem, const ProjectFolder& folder) {
  const auto shorten = [&](Json& text) { text = folder.withoutFolder(text.get<std::string>()); };
  shorten(problem["file"]);
  shorten(problem["text"]);
  for (Json& argument : problem["arguments"]) shorten(argument);
}

}  // namespace merker::workbench
