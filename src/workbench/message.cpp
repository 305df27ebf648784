#include "workbench/message.h"

namespace merker::workbench {
namespace {

// Before anything is built of it. Brackets inside texts do not count.
bool tooDeep(std::string_view text) {
  std::size_t depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '\\') ++i;
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if ((c == '{' || c == '[') && ++depth > kDeepest) return true;
    if ((c == '}' || c == ']') && depth > 0) --depth;
  }
  return false;
}

}  // namespace

Result<Json> parseMessage(std::string_view text) {
  if (tooDeep(text)) return makeProblem(ProblemCode::P1302, nowhere(), kDeepest);
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return makeProblem(ProblemCode::P1301, nowhere());
  return json;
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
