// Transmission times: from the first character of a telegram to the first of the next one, against
// those measured in the manual (6.10.6).
#include <cmath>
#include <fstream>
#include <regex>
#include <sstream>

#include "ascii_stations.h"
#include "links.h"

namespace merker::serial {
namespace {

constexpr std::uint32_t kMeasuredRates[] = {38400, 19200, 9600, 4800, 2400, 1200, 600, 300};

struct Row {
  std::string protocol;
  std::uint16_t bytes = 0;
  std::vector<double> measured;  // ms, in the order of kMeasuredRates
};

std::vector<Row> rows() {
  std::ifstream file(MERKER_SOURCE_DIR "/docs/requirements/technology-ptp.md");
  const std::regex pattern(
      R"(^\| PTP-TIME-\d+ \| (ASCII|3964|RK 512)[^,]*, (\d+) byte\(s\)[^:]*: ([0-9 /]+).*)");
  std::vector<Row> result;
  std::smatch match;
  for (std::string line; std::getline(file, line);) {
    if (!std::regex_match(line, match, pattern)) continue;
    Row row{match[1], static_cast<std::uint16_t>(std::stoul(match[2])), {}};
    std::istringstream numbers(match[3]);
    char slash = 0;
    for (double value = 0; numbers >> value; numbers >> slash) row.measured.push_back(value);
    result.push_back(row);
  }
  return result;
}

// Runs job after job; the time from the first character of the first to that of the second.
template <typename Start, typename Step, typename Ended>
double measure(Coupled& lines, const Start& start, const Step& step, const Ended& ended) {
  Instant first, second;
  for (Instant* begun : {&first, &second}) {
    const std::size_t before = lines.seen.size();
    start();
    while (lines.seen.size() == before) {
      lines.now = std::min(lines.line.next(), lines.now + Duration::milliseconds(1));
      lines.poke();
    }
    *begun = lines.seen[before].start;
    while (!ended()) {
      lines.now = lines.line.next();
      lines.poke();
      step();
    }
  }
  return static_cast<double>((second - first).ns) / 1e6;
}

double ascii(std::uint16_t bytes, const Settings& settings) {
  AsciiParameters parameters = byEnd();
  parameters.delay = Duration::milliseconds(130);
  AsciiCpu c(parameters, settings);
  Bytes data(bytes, 0x41);
  data.back() = 0x03;
  return measure(
      c.lines, [&] { c.send(data); }, [] {}, [&] { return c.cpu.outbox().takeEnd().has_value(); });
}

double procedure(std::uint16_t bytes, const Settings& settings) {
  Procedures p({}, low(), settings);
  return measure(
      p.lines, [&] { p.send(Bytes(bytes, 0x41)); }, [&] { p.mailB.clear(); },
      [&] { return p.a.outbox().takeEnd().has_value(); });
}

double computerLink(std::uint16_t bytes, const Settings& settings) {
  LinkCpu a, b(false);
  Coupled lines(a.driver, b.driver, settings, settings);
  b.memory.db(20).resize(1024);
  b.call(lines.now);
  return measure(
      lines, [&] { a.begin(sendJob(20, 0, bytes), Bytes(bytes, 0x41), lines.now); },
      [&] {
        for (LinkCpu* cpu : {&a, &b}) cpu->call(lines.now);
      },
      [&] { return a.driver.outbox().takeEnd().has_value(); });
}

double simulated(const Row& row, std::uint32_t baud) {
  const Settings settings{.baud = baud};
  if (row.protocol == "ASCII") return ascii(row.bytes, settings);
  return row.protocol == "3964" ? procedure(row.bytes, settings)
                                : computerLink(row.bytes, settings);
}

std::size_t characters(const Row& row) {
  if (row.protocol == "ASCII") return row.bytes;
  if (row.protocol == "3964") return row.bytes + 6U;
  const std::size_t telegrams = (row.bytes + 127U) / 128U;
  return row.bytes + telegrams * 20U + 6U;
}

// Two numbers of the manual are misprints, and its shortest telegrams have other characters
// (PTP-OPEN-23, PTP-OPEN-24).
bool excluded(const Row& row, double measured) {
  return measured == 13398 || measured == 2838 || (row.bytes == 1 && row.protocol != "3964");
}

// PTP-TIME-01, PTP-TIME-02, PTP-TIME-03, PTP-TIME-04, PTP-TIME-05, PTP-TIME-06, PTP-TIME-07,
// PTP-TIME-08 PTP-TIME-09, PTP-TIME-10, PTP-TIME-11, PTP-TIME-12, PTP-TIME-13, PTP-TIME-14,
// PTP-TIME-15, PTP-TIME-16 PTP-TIME-17, PTP-TIME-18, PTP-TIME-19, PTP-TIME-20, PTP-TIME-21,
// PTP-TIME-22, PTP-TIME-23, PTP-TIME-24 PTP-TIME-25, PTP-TIME-26
TEST(SerialTimes, AreThoseMeasuredInTheManual) {
  const std::vector<Row> all = rows();
  ASSERT_EQ(all.size(), 24U);
  for (const Row& row : all) {
    ASSERT_EQ(row.measured.size(), 8U);
    for (std::size_t i = 0; i < 8; ++i) {
      const double time = simulated(row, kMeasuredRates[i]), measured = row.measured[i];
      const double least =
          static_cast<double>(characters(row)) * 11e3 / static_cast<double>(kMeasuredRates[i]);
      EXPECT_GE(time, least - 0.001)
          << row.protocol << " " << row.bytes << " " << kMeasuredRates[i];
      if (excluded(row, measured)) continue;
      EXPECT_LE(std::abs(time - measured), std::max(measured / 10, 8.0))
          << row.protocol << " " << row.bytes << " at " << kMeasuredRates[i] << ": " << time;
    }
  }
}

}  // namespace
}  // namespace merker::serial
