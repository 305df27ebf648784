// Requests of browsers, one a line: whatever they contain, there is an answer in JSON, the PLC goes
// on, no file outside of the project folder changes, and none takes longer than it may: 50 ms of
// the PLC's thread, a second of a worker. @300(text) in a line stands for so many texts, so that a
// short input can be a long request.
#include "workbench/workbench.h"

#include <unistd.h>

#include <deque>
#include <filesystem>
#include <fstream>

#include "time_limit.h"

using namespace merker;
namespace fs = std::filesystem;

namespace {

constexpr const char* kProgram =
    "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n U E 0.0;\n = A 0.0;\nEND_FUNCTION\n"
    "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n CALL FC 1;\n L MW 10;\n + 1;\n T MW 10;\n"
    "END_ORGANIZATION_BLOCK\n";

// Beside the project lies a file that nobody may touch.
class World {
 public:
  World() : folder_(fs::temp_directory_path() / ("merker-fuzz-" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "work" / "plant");
    write("outside", "untouched");
    write("work/plant/merker.toml", "[project]\nname = \"Fuzz\"\n");
    write("work/plant/main.awl", kProgram);
  }
  ~World() { fs::remove_all(folder_); }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  std::string path(const char* name) const { return (folder_ / name).string(); }
  bool untouched() const {
    std::ifstream file(folder_ / "outside");
    std::string word;
    return (file >> word) && word == "untouched" &&
           std::distance(fs::directory_iterator(folder_), fs::directory_iterator()) == 2;
  }

 private:
  void write(const char* name, const char* text) { std::ofstream(folder_ / name) << text; }
  fs::path folder_;
};

double slowness() {
  static const double factor = fuzz::slowness(0.010, [] {
    std::string text = "[0";
    for (int i = 0; i < 20'000; ++i) text += R"(,{"operand": "MW 10", "value": "16#00FF"})";
    fuzz::require(workbench::dump(workbench::Json::parse(text + "]")).size() > text.size() / 2,
                  "the reference is JSON");
  });
  return factor;
}

template <typename Do>
auto within(double seconds, const char* property, Do&& work) {
  return fuzz::within(seconds * slowness(), property, std::forward<Do>(work));
}

constexpr double kRequest = 0.050, kWork = 1.0;

// @300(text): three hundred texts.
std::string expanded(std::string_view line) {
  constexpr std::size_t kLongest = 1 << 20;
  std::string text;
  while (!line.empty() && text.size() < kLongest) {
    const std::size_t mark = std::min(line.find('@'), line.size());
    text += line.substr(0, mark);
    line.remove_prefix(mark);
    const std::size_t open = line.find('('), close = line.find(')');
    const bool good =
        open != std::string_view::npos && open > 1 && open < 8 && close > open &&
        close != std::string_view::npos &&
        line.substr(1, open - 1).find_first_not_of("0123456789") == std::string_view::npos;
    if (!good) {
      text += line.substr(0, 1);
      line.remove_prefix(std::min<std::size_t>(line.size(), 1));
      continue;
    }
    const std::string_view part = line.substr(open + 1, close - open - 1);
    for (int count = std::stoi(std::string(line.substr(1, open - 1)));
         count > 0 && text.size() < kLongest; --count)
      text += part;
    line.remove_prefix(close + 1);
  }
  return text;
}

// The answer, whenever it comes; what others do meanwhile they do afterwards here.
void ask(workbench::Workbench& bench, const std::string& message,
         std::deque<workbench::Work>& works) {
  const workbench::Request request = workbench::readRequest(message);
  std::string answer = within(kRequest, "a request takes no longer than 50 ms",
                              [&] { return bench.handle(1, request); });
  while (answer.empty()) {
    fuzz::require(!works.empty(), "somebody works for the answer");
    for (; !works.empty(); works.pop_front())
      within(kWork, "a worker needs no longer than a second",
             [&] { return works.front()->carryOut(), 0; });
    const auto answers = within(kRequest, "an answer takes no longer than 50 ms",
                                [&] { return bench.laterAnswers(); });
    if (!answers.empty()) answer = answers[0].second;
  }
  fuzz::require(workbench::Json::accept(answer), "an answer is JSON");
}

void look(workbench::Workbench& bench) {
  static std::int64_t wall = 0;
  const auto frame = [&] {
    bench.advance([] { return wall += 100'000; }, Duration::milliseconds(1));
    bench.beginFrame(wall / 1'000'000);
    constexpr double kSlice = 0.005;  // as the program gives it
    return bench.events(1,
                        [end = fuzz::used() + kSlice * slowness()] { return fuzz::used() > end; });
  };
  for (const std::string& text : within(kRequest, "a frame takes no longer than 50 ms", frame))
    fuzz::require(workbench::Json::accept(text), "an event is JSON");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const World world;
  std::deque<workbench::Work> works;
  workbench::Workbench bench;
  const auto work = [&](workbench::Work one) { works.push_back(std::move(one)); };
  bench.compileBy(work);
  bench.helpBy(work);
  bench.importBy(work);
  bench.use({world.path("work"), {}, {}});
  bench.show(std::make_unique<workbench::Plc>(
      compilation::build(project::load(world.path("work/plant"), {}), false)));
  bench.opened(1);
  std::string_view text = fuzz::text(data, size);
  for (int count = 0; !text.empty() && count < 50; ++count) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    ask(bench, expanded(line), works);
    look(bench);
  }
  fuzz::require(world.untouched(), "nothing outside of the workspace changes");
  return 0;
}
