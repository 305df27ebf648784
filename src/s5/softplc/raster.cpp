#include "softplc/raster.h"

#include <array>

namespace merker::sinumerik {
namespace {

// By MD 155. Tenths of a second: SW 1 counts 5 IPO clocks, SW 2 the deviations that the manual
// prints; seconds and tens of seconds as printed (S5-SCHED-T2). Rows 4 and 5 follow the rules of
// OP-11.
struct Row {
  Duration sampling, tenthSw1, tenthSw2, second, ten;
};
constexpr Duration us(std::int64_t n) { return Duration::microseconds(n); }
constexpr std::array kRasterRows{
    Row{us(4000), us(80'000), us(100'000), us(950'000), us(10'000'000)},
    Row{us(4500), us(90'000), us(99'000), us(990'000), us(9'999'000)},
    Row{us(5000), us(100'000), us(100'000), us(1'000'000), us(10'000'000)},
    Row{us(5500), us(110'000), us(98'000), us(990'000), us(9'999'000)},
    Row{us(6000), us(120'000), us(102'000), us(1'002'000), us(10'002'000)},
    Row{us(6500), us(130'000), us(97'500), us(1'001'000), us(9'997'000)}};

constexpr unsigned kStandardFactor = 3;  // also what 0 means (OP-18)
constexpr int kSamplesPerHundredth = 2;  // base 0.01 s: the manual calls it unusable

}  // namespace

Raster makeRaster(std::uint8_t samplingCode, unsigned callFactor, mc5::Variant variant,
                  Software software) {
  const Row& row = kRasterRows[samplingCode < kRasterRows.size() ? samplingCode : 2];
  const bool fixed = variant == mc5::Variant::Cop || callFactor == 0 || callFactor > 3;
  const unsigned factor = fixed ? kStandardFactor : callFactor;
  const Duration ipo = row.sampling * kSamplesPerIpo;
  return {row.sampling,
          ipo,
          factor,
          ipo * factor,
          {row.sampling * kSamplesPerHundredth,
           software == Software::Sw1 ? row.tenthSw1 : row.tenthSw2, row.second, row.ten}};
}

}  // namespace merker::sinumerik
