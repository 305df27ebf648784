// A workbench over a real station with a project folder of its own, and one browser.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "conforms.h"
#include "workbench/workbench.h"

namespace merker::workbench::test {

// A 0.0 follows E 0.0, A 0.1 comes 2 s after it, MW 20 counts cycles, E 0.7 leads to a fault.
inline const char* const kProgram = R"(DATA_BLOCK DB 1
STRUCT
  count : INT := 5;
  level : REAL := 1.5;
END_STRUCT
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      U     E 0.0;
      =     A 0.0;
      L     S5T#2S;
      SE    T 1;
      U     T 1;
      =     A 0.1;
      L     MW 20;
      +     1;
      T     MW 20;
      UN    E 0.7;
      SPB   good;
      L     W#16#FFFF;
      BTI   ;
good: NOP   0;
END_ORGANIZATION_BLOCK
)";
inline const char* const kSymbols =
    "\"Start\"  E 0.0  BOOL  // the button\n\"Motor\"  A 0.0  BOOL\n\"Counted\"  MW 20  INT\n";

class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / name()) {
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string path(const std::string& file = {}) const { return (path_ / file).string(); }
  void write(const std::string& file, const std::string& text) const {
    std::filesystem::create_directories((path_ / file).parent_path());
    std::ofstream(path(file), std::ios::binary) << text;
  }
  std::string read(const std::string& file) const {
    std::ifstream in(path(file), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

 private:
  static std::string name() {
    static int number = 0;
    return "merker-bench-" + std::to_string(::getpid()) + "-" + std::to_string(++number);
  }
  std::filesystem::path path_;
};

class Bench {
 public:
  explicit Bench(const std::string& program = kProgram, const std::string& settings = {}) {
    folder.write("merker.toml", "[project]\nname = \"Test\"\n" + settings);
    folder.write("main.awl", program);
    folder.write("main.sym", kSymbols);
    workbench.show(
        std::make_unique<Plc>(compilation::build(project::load(folder.path(), {}), false)));
    workbench.opened(1);
    run(Duration::milliseconds(10));
  }

  // The whole answer, its result, the codes of its problems.
  Json ask(const std::string& method, Json fields = Json::object(), Workbench::BrowserId who = 1) {
    fields["id"] = ++last_;
    fields["do"] = method;
    Json answer = Json::parse(workbench.handle(who, fields.dump()));
    EXPECT_EQ(answer["id"], last_);
    const MethodRow* row = findMethodRow(method);
    if (row != nullptr && answer.contains("result")) {
      EXPECT_EQ(mismatch(row->result, answer["result"], method), "");
    }
    return answer;
  }
  Json call(const std::string& method, Json fields = Json::object(), Workbench::BrowserId who = 1) {
    Json answer = ask(method, std::move(fields), who);
    EXPECT_TRUE(answer.contains("result")) << method << ": " << answer.dump();
    return answer["result"];
  }
  std::string problem(const std::string& method, Json fields = Json::object()) {
    const Json answer = ask(method, std::move(fields));
    return answer.contains("problems") ? answer["problems"][0]["code"].get<std::string>()
                                       : answer.dump();
  }
  // Events of the next frame.
  std::vector<Json> events(Workbench::BrowserId who = 1) {
    std::vector<Json> list;
    workbench.beginFrame(now_ += 33);
    for (const std::string& text : workbench.events(who)) {
      list.push_back(Json::parse(text));
      check(list.back());
    }
    return list;
  }
  Json event(const std::string& name, Workbench::BrowserId who = 1) {
    for (Json& one : events(who))
      if (one["event"] == name) return one;
    return nullptr;
  }
  Json state() {
    Json fresh;
    workbench.opened(99);
    fresh = event("state", 99);
    workbench.closed(99);
    return fresh;
  }
  // Virtual time in real-time mode, with a wall clock that this moves.
  void run(Duration time) {
    controller::Controller& plc = workbench.plc()->controller();
    plc.advanceTo(plc.now() + time);
    plc.settle();
  }

  Folder folder;
  Workbench workbench;

 private:
  // An event must be as protocol.def has it.
  static void check(Json event) {
    const std::string name = event["event"];
    const Shape* shape = eventShape(name);
    ASSERT_NE(shape, nullptr) << name;
    event.erase("event");
    EXPECT_EQ(mismatch(*shape, event, name), "");
  }

  std::uint64_t last_ = 0;
  std::int64_t now_ = 0;
};

}  // namespace merker::workbench::test
