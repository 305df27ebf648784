// Numbers of the job errors (technology manual 5.10.3).
#include <gtest/gtest.h>

#include "technology/counter.h"
#include "technology/frequency.h"
#include "technology/pulse_width.h"

namespace merker::technology {
namespace {

Counter counter(io::CountDirection direction, std::int32_t end) {
  io::CountChannel p;
  p.mode = io::CountMode::Periodic;
  p.direction = direction;
  p.endValue = end;
  Counter result(p);
  result.start(false, {});
  return result;
}

// CNT-ERR-02, CNT-JOB-05, CNT-JOB-06, CNT-HYST-08, CNT-JOB-15
TEST(CounterJobs, Ranges) {
  Counter c = counter(io::CountDirection::None, 2'147'483'647);
  EXPECT_EQ(c.job(1, 2'147'483'647).error, 0x0162);
  EXPECT_EQ(c.job(1, -2'147'483'647 - 1).error, 0x0161);
  EXPECT_EQ(c.job(2, 2'147'483'647).error, 0x0152);
  EXPECT_EQ(c.job(8, 300).error, 0x0132);
  EXPECT_EQ(c.job(8, -1).error, 0x0131);
  EXPECT_EQ(c.job(0x88, 0).value, 0);
  EXPECT_EQ(c.job(0x10, -1).error, 0x0141);
  EXPECT_EQ(c.job(0x10, 511).error, 0x0142);
  for (std::uint32_t id = 0; id <= 0xFF; ++id) {
    const bool known = id == 0 || id == 1 || id == 2 || id == 4 || id == 8 || id == 0x10 ||
                       id == 0x82 || id == 0x84 || id == 0x88 || id == 0x90;
    EXPECT_EQ(c.job(id, 0).error == 0x01FF, !known) << id;
  }
}

// CNT-JOB-07, CNT-JOB-08, CNT-JOB-09, CNT-JOB-10, CNT-CMP-01
TEST(CounterJobs, WithMainDirection) {
  Counter forward = counter(io::CountDirection::Forward, 10);
  EXPECT_EQ(forward.job(1, 9).error, 0x0162);
  EXPECT_EQ(forward.job(1, 8).error, 0);
  EXPECT_EQ(forward.count(), 8);
  EXPECT_EQ(forward.job(4, 10).error, 0x0122);
  EXPECT_EQ(forward.job(4, 9).error, 0);
  EXPECT_EQ(forward.job(0x84, 0).value, 9);
  EXPECT_EQ(forward.job(0x10, 7).error, 0);
  EXPECT_EQ(forward.job(0x90, 0).value, 6);
  Counter backward = counter(io::CountDirection::Backward, 10);
  EXPECT_EQ(backward.job(2, 1).error, 0x0151);
  EXPECT_EQ(backward.job(4, 0).error, 0x0121);
  EXPECT_EQ(backward.job(0x82, 0).value, 10);
}

// CNT-ERR-03, CNT-JOB-11, CNT-JOB-12
TEST(FrequencyJobs, Ranges) {
  io::CountChannel p;
  p.highLimit = 1000;
  Frequency f(p, 60'000'000);
  EXPECT_EQ(f.job(4, 9).error, 0x0221);
  EXPECT_EQ(f.job(4, 10'001).error, 0x0222);
  EXPECT_EQ(f.job(1, -1).error, 0x0231);
  EXPECT_EQ(f.job(1, 1000).error, 0x0232);
  EXPECT_EQ(f.job(2, 0).error, 0x0241);
  EXPECT_EQ(f.job(2, 60'000'001).error, 0x0242);
  EXPECT_EQ(f.job(0x81, 0).value, 0);
  EXPECT_EQ(f.job(0x82, 0).value, 1000);
  EXPECT_EQ(f.job(0x84, 0).value, 100);
  for (std::uint32_t id = 0; id <= 0xFF; ++id) {
    const bool known =
        id == 0 || id == 1 || id == 2 || id == 4 || id == 0x81 || id == 0x82 || id == 0x84;
    EXPECT_EQ(Frequency(p, 60'000'000).job(id, 0).error == 0x02FF, !known) << id;
  }
}

// CNT-ERR-04, CNT-JOB-13, CNT-JOB-14, CNT-PWM-14, CNT-PWM-15
TEST(PulseJobs, Ranges) {
  io::CountChannel p;
  p.minimumPulse = 50;
  PulseWidth pwm(p);
  EXPECT_EQ(pwm.job(1, 99, {}).error, 0x0411);
  EXPECT_EQ(pwm.job(1, 100, {}).error, 0);
  EXPECT_EQ(pwm.job(1, 65'536, {}).error, 0x0412);
  EXPECT_EQ(pwm.job(2, -1, {}).error, 0x0421);
  EXPECT_EQ(pwm.job(2, 65'536, {}).error, 0x0422);
  EXPECT_EQ(pwm.job(4, 1, {}).error, 0x0431);
  EXPECT_EQ(pwm.job(4, 51, {}).error, 0x0432);
  EXPECT_EQ(pwm.job(0x83, 0, {}).value, 50);
  EXPECT_EQ(pwm.job(0x84, 0, {}).value, 50);
  EXPECT_EQ(pwm.job(0x81, 0, {}).value, 100);
  for (std::uint32_t id = 0; id <= 0xFF; ++id) {
    const bool known = id <= 4 ? id != 3 : id >= 0x81 && id <= 0x84;
    EXPECT_EQ(PulseWidth(p).job(id, 0, {}).error == 0x04FF, !known) << id;
  }
  p.milliseconds = true;
  p.minimumPulse = 0;
  PulseWidth slow(p);
  EXPECT_EQ(slow.job(1, 0, {}).error, 0x0411);
  EXPECT_EQ(slow.job(1, 1, {}).error, 0);
  EXPECT_EQ(slow.job(4, -1, {}).error, 0x0431);
  EXPECT_EQ(slow.job(4, 1, {}).error, 0x0432);  // more than half of the period
}

}  // namespace
}  // namespace merker::technology
