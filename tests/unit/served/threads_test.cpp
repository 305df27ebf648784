// Both threads at once: what is read is of one cycle, and every write is answered.
#include <thread>

#include "served_plc.h"

namespace merker::served {
namespace {

// S7-LIM-02
TEST(Threads, aValueIsOfOneCycle) {
  ServedPlc plc = ServedPlc::station();
  plc.exchange.opened();
  plc.cycles(1);
  std::atomic<bool> over = false;
  std::atomic<unsigned> answers = 0;
  unsigned torn = 0, waited = 0, writes = 0;
  std::thread connections([&] {
    for (int i = 0; i < 20'000; ++i) {
      bool read = false;
      plc.exchange.read({flags(10, 1), flags(11, 1)}, [&](const std::vector<Value>& values) {
        read = true;
        torn += values[0].octets != values[1].octets ? 1u : 0u;
      });
      waited += read ? 0u : 1u;
      if (i % 100 != 0) continue;
      ++writes;
      plc.exchange.write({{flags(120, 1), {7}}}, [&](const std::vector<ItemCode>&) { ++answers; });
    }
    over = true;
  });
  while (!over) plc.cycles(1);
  connections.join();
  plc.cycles(1);
  EXPECT_EQ(torn, 0u);
  EXPECT_EQ(waited, 0u);
  EXPECT_EQ(answers, writes);
}

}  // namespace
}  // namespace merker::served
