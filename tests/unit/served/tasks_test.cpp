#include "served/tasks.h"

#include "served_plc.h"

namespace merker::served {
namespace {

using s7comm::Outlet;

// Says how often it has run; ends when it is told to, or after so many times.
class Counting : public Task {
 public:
  Counting(std::shared_ptr<Outlet> client, int most, int& ends)
      : Task(std::move(client)), most_(most), ends_(ends) {}
  bool run(monitor::Monitor&) override {
    client().send({.group = 2, .octets = {static_cast<std::uint8_t>(++runs)}});
    return runs < most_;
  }
  void end(monitor::Monitor&) override { ++ends_; }
  int runs = 0;

 private:
  int most_;
  int& ends_;
};

class TasksOfAPlc : public ::testing::Test {
 protected:
  TasksOfAPlc() {
    client->setRoom(100);
    client->deliverBy([this] {
      while (const auto one = client->take()) heard.push_back(one->octets.at(0));
    });
  }
  void begin(int most) { tasks.begin(std::make_shared<Counting>(client, most, ends)); }
  void run() {
    tasks.run(plc.monitor(), [](const std::function<void()>& call) { call(); });
  }

  ServedPlc plc = ServedPlc::station();
  std::shared_ptr<Outlet> client = std::make_shared<Outlet>();
  Tasks tasks;
  Bytes heard;
  int ends = 0;
};

TEST_F(TasksOfAPlc, runUntilTheyAreOver) {
  begin(2);
  for (int i = 0; i < 4; ++i) run();
  EXPECT_EQ(heard, (Bytes{1, 2}));
  EXPECT_EQ(ends, 1);
}

TEST_F(TasksOfAPlc, endWithTheirConnection) {
  begin(100);
  run();
  client->close();
  run();
  run();
  EXPECT_EQ(heard, Bytes{1});
  EXPECT_EQ(ends, 1);
}

TEST_F(TasksOfAPlc, areFoundCountedAndRemoved) {
  begin(1);
  begin(100);
  const auto other = std::make_shared<Outlet>();
  EXPECT_EQ(tasks.count<Counting>(*client), 2u);
  EXPECT_EQ(tasks.count<Counting>(*other), 0u);
  run();
  EXPECT_EQ(tasks.count<Counting>(*client), 1u);
  const auto* const one =
      tasks.find<Counting>(*client, [](const Counting& c) { return c.runs == 1; });
  ASSERT_NE(one, nullptr);
  tasks.remove(*one, plc.monitor());
  EXPECT_EQ(tasks.count<Counting>(*client), 0u);
  EXPECT_EQ(ends, 2);
}

}  // namespace
}  // namespace merker::served
