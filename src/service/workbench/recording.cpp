#include "workbench/recording.h"

#include <algorithm>

#include "workbench/message.h"
#include "workbench/protocol.h"

namespace merker::workbench {
namespace {

constexpr const char* kExample =
    R"({"at":1500000000,"do":"variables.write","items":[{"operand":"E 0.0","value":"1"}]})";

Problem wrong(const std::string& path, std::uint32_t line, const std::string& why) {
  return makeProblem(ProblemCode::P1321, Position{path, line, 1, 0},
                     fmt::format("{}; write it like {}", why, kExample));
}

constexpr std::int64_t kLatest = 1'000'000'000'000'000;  // ns, 11 days

// Why not; empty if it is an action that does not go back in time.
std::string whyNot(const Json& line, Duration before) {
  const auto at = line.find("at"), what = line.find("do");
  if (at == line.end() || !at->is_number_integer() || *at < 0 || *at > kLatest)
    return fmt::format("'at' is a whole number of nanoseconds, at most {}", kLatest);
  if (at->get<std::int64_t>() < before.ns) return "its time is before that of the line above";
  if (what == line.end() || !what->is_string()) return "'do' is missing";
  if (!isAction(what->get_ref<const std::string&>()))
    return fmt::format("'{}' cannot be recorded",
                       what->get_ref<const std::string&>().substr(0, 100));
  return {};
}

}  // namespace

bool isAction(const std::string& name) {
  const Method* method = findMethod(name);
  return method != nullptr && method->kind == Kind::Action;
}

std::string recordingText(const std::vector<Action>& actions) {
  std::string text;
  for (const Action& action : actions) {
    Json line = *action.request;
    line["at"] = action.at.ns;
    text += dump(line) + "\n";
  }
  return text;
}

Result<std::vector<Action>, Problems> parseRecording(const std::string& path,
                                                     std::string_view text) {
  std::vector<Action> actions;
  Problems problems;
  Duration before;
  for (std::uint32_t number = 1; !text.empty(); ++number) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    if (line.empty()) continue;
    auto request = parseMessage(line);
    const std::string why = request ? whyNot(*request, before) : "it is not a JSON object";
    if (!why.empty() || actions.size() >= Recorder::kMost) {
      problems.add(wrong(path, number, why.empty() ? "there are too many" : why));
      break;
    }
    before = Duration{(*request)["at"].get<std::int64_t>()};
    actions.push_back({before, std::make_shared<const Json>(std::move(*request))});
  }
  if (problems.hasErrors()) return problems;
  return actions;
}

namespace {

// What the protocol knows of it, whatever else a browser has put into it; `bytes`: what it takes in
// a file, about.
Json meaningful(const Shape& shape, const Json& value, std::size_t& bytes) {
  constexpr std::size_t kMarks = 8;
  if (shape.kind == Shape::Kind::List && value.is_array()) {
    Json list = Json::array();
    for (const Json& one : value) list.push_back(meaningful(shape.parts[0], one, bytes));
    return list;
  }
  bytes += kMarks + (value.is_string() ? value.get_ref<const std::string&>().size() : 0);
  if (shape.kind != Shape::Kind::Object || !value.is_object()) return value;
  Json result = Json::object();
  for (const Shape& field : shape.parts)
    if (const auto found = value.find(field.name); found != value.end()) {
      bytes += kMarks + field.name.size();
      result[field.name] = meaningful(field, *found, bytes);
    }
  return result;
}

}  // namespace

void Recorder::start(Instant now) {
  stop();
  begin_ = now;
  on_ = true;
}

void Recorder::stop() { *this = {}; }

void Recorder::note(const Json& request, Instant now) {
  const std::string name = request.value("do", "");
  const MethodRow* row = findMethodRow(name);
  if (!on_ || full_ || row == nullptr) return;
  std::size_t bytes = name.size();
  Json kept = meaningful(row->fields, request, bytes);
  kept["do"] = name;
  full_ = actions_.size() >= kMost || bytes_ + bytes > kMostBytes;
  if (full_) return;
  bytes_ += bytes;
  actions_.push_back({now - begin_, std::make_shared<const Json>(std::move(kept))});
}

void Player::start(std::string path, std::vector<Action> actions, Instant now) {
  stop();
  path_ = std::move(path);
  actions_ = std::move(actions);
  begin_ = now;
  state_ = actions_.empty() ? State::Ended : State::Playing;
}

void Player::pause(bool paused, Instant now) {
  if (paused && state_ == State::Playing) {
    state_ = State::Paused;
    pausedAt_ = now;
  } else if (!paused && state_ == State::Paused) {
    state_ = State::Playing;
    begin_ = begin_ + (now - pausedAt_);
  }
}

Instant Player::next() const {
  return state_ == State::Playing ? begin_ + actions_[done_].at : Instant::never();
}

std::shared_ptr<const Json> Player::take() {
  std::shared_ptr<const Json> request = actions_[done_++].request;
  if (done_ == actions_.size()) state_ = State::Ended;
  return request;
}

Json Player::describe() const {
  constexpr std::string_view kStates[] = {"none", "playing", "paused", "ended", "failed"};
  if (state_ == State::None) return nullptr;
  Json json = {{"path", path_},
               {"actions", actions_.size()},
               {"done", done_},
               {"state", kStates[static_cast<std::size_t>(state_)]}};
  if (!problem_.is_null()) json["problem"] = problem_;
  return json;
}

}  // namespace merker::workbench
