// Values of the protocol.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>

#include "base/problem.h"
#include "base/result.h"

namespace merker::workbench {

using Json = nlohmann::json;

struct Later;

// What a request is answered with: a result, or problems; or later, when something is compiled.
class Answer {
 public:
  Answer(Json result) : good_(true), json_(std::move(result)) {}
  Answer(const Problems& problems);
  // A list of problems with more fields than others have.
  static Answer refused(Json list);

  static Answer later(std::shared_ptr<Later> later);
  // With its text, which was written elsewhere.
  static Answer written(bool good, std::string text);

  explicit operator bool() const { return good_; }
  // Empty: only the JSON is there.
  std::string& text() { return text_; }
  const std::shared_ptr<Later>& waits() const { return later_; }
  const Json& json() const { return json_; }
  Json& json() { return json_; }

 private:
  bool good_;
  Json json_;
  std::string text_;
  std::shared_ptr<Later> later_;
};

// As text; bytes that are no UTF-8 are replaced.
std::string dump(const Json& json);
// {"code", "severity", "file", "line", "column", "length", "text", "arguments"}
Json toJson(const Problem& problem);
Json toJson(const Problems& problems);
// The first of them: a person does not read thousands.
constexpr std::size_t kMostProblems = 2000;
Json firstOf(const Problems& problems);

Problems one(Problem problem);
Position nowhere();

template <typename... Arguments>
Problems refused(ProblemCode code, const Arguments&... arguments) {
  return one(makeProblem(code, nowhere(), arguments...));
}

}  // namespace merker::workbench
