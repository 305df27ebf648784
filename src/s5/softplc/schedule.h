// When the operating system has something to do: samplings, thirds of the call raster, calls of
// OB 1. Counted from the end of the start-up (S5-SCHED-01, -02, -06).
#pragma once

#include "softplc/raster.h"

namespace merker::sinumerik {

class Schedule {
 public:
  void begin(Instant anchor, const Raster& raster) {
    anchor_ = anchor;
    raster_ = raster;
    samples_ = thirds_ = 0;
  }
  void delay(Duration by) { anchor_ = anchor_ + by; }
  const Raster& raster() const { return raster_; }
  Instant nextSample() const { return anchor_ + raster_.sampling * samples_; }
  Instant nextThird() const { return anchor_ + Duration{raster_.call.ns * thirds_ / 3}; }
  Instant next() const { return nextSample() < nextThird() ? nextSample() : nextThird(); }
  // What the sampling that nextSample() names begins.
  bool beginsIpoClock() const { return samples_ % kSamplesPerIpo == 0; }
  bool callsOb1() const { return samples_ % (kSamplesPerIpo * raster_.factor) == 0; }
  // The sampling that begins the IPO clock `count` behind the last one that has begun.
  Instant ipoClock(std::int64_t count) const {
    const std::int64_t begun = (samples_ + kSamplesPerIpo - 1) / kSamplesPerIpo;
    return anchor_ + raster_.sampling * ((begun + count - 1) * kSamplesPerIpo);
  }
  // So many call rasters have passed.
  void pass(std::uint64_t rasters) {
    samples_ += static_cast<std::int64_t>(rasters) * kSamplesPerIpo * raster_.factor;
    thirds_ += 3 * static_cast<std::int64_t>(rasters);
  }
  void sampled() { ++samples_; }
  void thirdBegun() { ++thirds_; }

 private:
  Instant anchor_;
  Raster raster_{};
  std::int64_t samples_ = 0, thirds_ = 0;
};

}  // namespace merker::sinumerik
