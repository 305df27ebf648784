// [cpu] of merker.toml (S7-HWCFG-08).
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "io/amount.h"
#include "project/readers.h"

namespace merker::project {
namespace {

// PERIOD of SFC 28, in the order of the words below (S7-OBI-03).
constexpr std::uint16_t kPeriods[] = {0x0000, 0x0201, 0x0401, 0x1001,
                                      0x1201, 0x1401, 0x1801, 0x2001};

// The number of a key like OB35; 0 if it is none.
unsigned obNumber(std::string_view key) {
  unsigned number = 0;
  if (!key.starts_with("OB")) return 0;
  const char* end = key.data() + key.size();
  const auto result = std::from_chars(key.data() + 2, end, number);
  return result.ec == std::errc() && result.ptr == end ? number : 0;
}

bool isTimeOfDay(unsigned ob) { return ob >= 10 && ob <= 17; }
bool isCyclic(unsigned ob) { return ob >= 30 && ob <= 38; }

void readTimes(const Table& table, CpuParameters& parameters) {
  const auto monitoring = table.milliseconds("cycle_monitoring", 1, 6000);
  if (monitoring) parameters.cycleMonitoring = *monitoring;
  const auto minimum = table.milliseconds("minimum_cycle", 0, 6000);
  if (!minimum) return;
  parameters.minimumCycle = *minimum;
  if (parameters.minimumCycle >= parameters.cycleMonitoring)
    table.mustBe("minimum_cycle", fmt::format("shorter than cycle_monitoring, which is {} ms",
                                              parameters.cycleMonitoring));
}

void readRanges(const Table& table, const CpuModel& model, CpuParameters& parameters) {
  const auto take = [&](std::string_view key, std::uint32_t most, std::uint32_t& value) {
    value = table.number(key, 0, most).value_or(value);
  };
  take("retentive_flags", model.flagBytes, parameters.retentiveFlags);
  take("retentive_timers", model.timers, parameters.retentiveTimers);
  take("retentive_counters", model.counters, parameters.retentiveCounters);
  if (const auto byte = table.number("clock_memory", 0, model.flagBytes - 1))
    parameters.clockMemory = *byte;
  if (const auto load = table.number("communication_load", 10, 50, "(%)"))
    parameters.communicationLoad = *load;
}

// The start information gives the interval as INT in ms (S7-OBI-05).
void readCyclic(const Table& table, unsigned ob, CpuParameters& parameters) {
  table.allow({"interval", "phase"});
  CyclicParameter cyclic{.ob = static_cast<std::uint8_t>(ob)};
  constexpr std::uint32_t kLongest = 60'000;
  const auto interval = table.milliseconds("interval", 1, kLongest);
  if (!table.has("interval"))
    table.problems().add(ProblemCode::P0744, table.place(), table.title(),
                         "an interval: interval = \"50ms\"");
  if (!interval) return;
  cyclic.interval = static_cast<std::int32_t>(*interval);
  if (const auto phase = table.milliseconds("phase", 0, kLongest)) {
    cyclic.phase = static_cast<std::int32_t>(*phase);
    if (*phase >= *interval) table.mustBe("phase", "shorter than the interval");
  }
  parameters.cyclic.push_back(cyclic);
}

void readTimeOfDay(const Table& table, unsigned ob, CpuParameters& parameters) {
  table.allow({"active", "period", "start"});
  TimeOfDayParameter time{.ob = static_cast<std::uint8_t>(ob)};
  time.active = table.flag("active").value_or(true);
  if (const auto period = table.choice(
          "period", {"once", "minute", "hour", "day", "week", "month", "year", "end of month"}))
    time.period = kPeriods[*period];
  if (const auto start = readDateAndTime(table, "start")) time.start = *start;
  parameters.timeOfDay.push_back(time);
}

// [cpu.OB35], [cpu.OB10]; every other key is one of the CPU or unknown.
void readOrganizationBlocks(const Table& table, const CpuModel& model, CpuParameters& parameters) {
  for (const std::string& key : table.keys()) {
    const unsigned ob = obNumber(key);
    if (!isTimeOfDay(ob) && !isCyclic(ob)) continue;
    const auto settings = table.table(key);
    if (!settings) continue;
    if (!model.hasOrganizationBlock(ob))
      table.problems().add(ProblemCode::P0746, table.placeOf(key), model.name, ob);
    else if (isCyclic(ob))
      readCyclic(*settings, ob, parameters);
    else
      readTimeOfDay(*settings, ob, parameters);
  }
}

}  // namespace

void readProtection(const Table& table, CpuParameters& parameters) {
  if (const auto level = table.number("protection", 1, 3))
    parameters.protection = static_cast<std::uint8_t>(*level);
  if (const auto password = table.text("password", "a text of 1 to 8 characters")) {
    parameters.password = *password;
    if (password->empty() || password->size() > 8)
      table.mustBe("password", "a text of 1 to 8 characters");
  }
  if (parameters.protection > 1 && !table.has("password"))
    table.problems().add(ProblemCode::P0744, table.at("protection"), "protection",
                         "a password: password = \"...\"");
}

void readCpuParameters(const Table& table, const CpuModel& model, CpuParameters& parameters) {
  table.allow({"model",
               "clock",
               "mpi_address",
               "cycle_monitoring",
               "minimum_cycle",
               "communication_load",
               "clock_memory",
               "retentive_flags",
               "retentive_timers",
               "retentive_counters",
               "start_on_mismatch",
               "image_errors",
               "protection",
               "password",
               "OB10",
               "OB11",
               "OB12",
               "OB13",
               "OB14",
               "OB15",
               "OB16",
               "OB17",
               "OB30",
               "OB31",
               "OB32",
               "OB33",
               "OB34",
               "OB35",
               "OB36",
               "OB37",
               "OB38"});
  readTimes(table, parameters);
  readRanges(table, model, parameters);
  readProtection(table, parameters);
  readOrganizationBlocks(table, model, parameters);
  parameters.startOnMismatch = table.flag("start_on_mismatch").value_or(parameters.startOnMismatch);
  if (const auto errors = table.choice("image_errors", {"none", "each cycle", "coming and going"}))
    parameters.imageErrors = static_cast<ImageErrors>(*errors);
}

}  // namespace merker::project
