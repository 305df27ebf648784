// Requests of browsers, one a line: whatever they contain, there is an answer in JSON, the PLC goes
// on, and no file outside of the project folder changes.
#include "workbench/workbench.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "harness.h"

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

void look(workbench::Workbench& bench) {
  static std::int64_t wall = 0;
  bench.advance([] { return wall += 100'000; }, Duration::milliseconds(1));
  bench.beginFrame(wall / 1'000'000);
  for (const std::string& text : bench.events(1))
    fuzz::require(workbench::Json::accept(text), "an event is JSON");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const World world;
  workbench::Workbench bench;
  bench.use({world.path("work"), {}, {}});
  bench.show(std::make_unique<workbench::Plc>(
      compilation::build(project::load(world.path("work/plant"), {}), false)));
  bench.opened(1);
  std::string_view text = fuzz::text(data, size);
  for (int count = 0; !text.empty() && count < 50; ++count) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    fuzz::require(workbench::Json::accept(bench.handle(1, line)), "an answer is JSON");
    look(bench);
  }
  fuzz::require(world.untouched(), "nothing outside of the workspace changes");
  return 0;
}
