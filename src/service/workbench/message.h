// One message of a browser: a JSON object, neither nested deeper nor of more values than the
// protocol allows.
#pragma once

#include <string_view>

#include "workbench/json.h"
#include "workbench/project_folder.h"

namespace merker::workbench {

// A value takes up to 160 bytes: a message of 4 MB cannot become a gigabyte.
constexpr std::size_t kDeepest = 32, kMostValues = 150'000;

Result<Json> parseMessage(std::string_view text);

// The request of a message, or what is wrong with it; made in whatever thread.
struct Request {
  std::shared_ptr<const Json> json;  // null: it is none
  std::optional<Problem> wrong;
  std::size_t bytes = 0;  // of the message
};
Request readRequest(std::string_view message);
// A longer message is read and freed elsewhere.
constexpr std::size_t kSmallMessage = 16 << 10;

// 0: there is none.
std::int64_t requestId(const Json& request);

// The files that a problem names, relative to the project folder.
void relate(Json& problem, const ProjectFolder& folder);

}  // namespace merker::workbench
