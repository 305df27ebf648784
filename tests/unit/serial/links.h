// CPUs with RK 512, for tests.
#pragma once

#include <map>
#include <set>

#include "serial/rk512.h"
#include "stations.h"

namespace merker::serial {

// Data blocks and areas of a CPU; timers and counters are words.
class Areas : public LinkMemory {
 public:
  std::optional<std::size_t> size(char type, std::uint8_t block) const override {
    const auto found = bytes.find({type, block});
    if (found == bytes.end()) return std::nullopt;
    return type == 'T' || type == 'Z' ? found->second.size() / 2 : found->second.size();
  }
  bool writable(std::uint8_t block) const override { return !locked.contains(block); }
  Bytes read(char type, std::uint8_t block, std::size_t offset, std::size_t count) const override {
    const Bytes& area = bytes.at({type, block});
    const auto at = static_cast<std::ptrdiff_t>(type == 'T' || type == 'Z' ? offset * 2 : offset);
    return {area.begin() + at, area.begin() + at + static_cast<std::ptrdiff_t>(count)};
  }
  void write(std::uint8_t block, std::size_t offset, std::span<const std::uint8_t> data) override {
    std::copy(data.begin(), data.end(),
              bytes.at({'D', block}).begin() + static_cast<std::ptrdiff_t>(offset));
  }
  bool flag(const Flag& f) const override {
    return (bytes.at({'M', std::uint8_t{0}})[f.byte] >> f.bit & 1U) != 0;
  }
  void setFlag(const Flag& f) override {
    std::uint8_t& byte = bytes.at({'M', std::uint8_t{0}})[f.byte];
    byte = static_cast<std::uint8_t>(byte | 1U << f.bit);
  }
  Bytes& db(std::uint8_t number) { return bytes[{'D', number}]; }
  Bytes& area(char type) { return bytes[{type, std::uint8_t{0}}]; }

  std::map<std::pair<char, std::uint8_t>, Bytes> bytes;
  std::set<std::uint8_t> locked;  // write-protected data blocks
};

inline LinkParameters link(bool high) {
  LinkParameters parameters;
  parameters.procedure.highPriority = high;
  return parameters;
}

// What the program of a CPU does: calls of SEND_RK, FETCH_RK and SERVE_RK.
class LinkCpu {
 public:
  explicit LinkCpu(bool high = true, LinkParameters parameters = {})
      : driver((parameters.procedure.highPriority = high, parameters)) {
    memory.area('M').resize(256);
  }
  void begin(const LinkJob& job, Bytes data, Instant now) {
    source = std::move(data);
    target.clear();
    driver.begin(job, now);
    call(now);
  }
  void call(Instant now) {
    if (serves) driver.serve(memory, now);
    if (const auto part = driver.wanted()) {
      const auto at = source.begin() + static_cast<std::ptrdiff_t>(part->offset);
      driver.supply({at, at + static_cast<std::ptrdiff_t>(part->count)}, now);
    }
    if (const auto data = driver.takeFetched(now))
      target.insert(target.end(), data->begin(), data->end());
    while (const auto outcome = driver.takeOutcome()) outcomes.push_back(*outcome);
  }
  std::string end() { return number(driver.outbox().takeEnd()); }
  std::string events() const {
    std::string result;
    for (const Rk512::Outcome& outcome : outcomes)
      result += (result.empty() ? "" : "; ") + number(outcome.event);
    return result;
  }

  Rk512 driver;
  Areas memory;
  Bytes source, target;
  std::vector<Rk512::Outcome> outcomes;
  bool serves = true;
};

// Runs a line in cycles of a millisecond; the programs of the CPUs are called in each.
inline void cycles(Coupled& lines, std::initializer_list<LinkCpu*> cpus, unsigned count) {
  for (unsigned i = 0; i < count; ++i) {
    lines.run(1);
    for (LinkCpu* cpu : cpus) cpu->call(lines.now);
  }
}

// A CPU with RK 512 and a partner with a script.
class LinkedScript {
 public:
  explicit LinkedScript(LinkParameters parameters = {})
      : cpu(true, parameters), lines(cpu.driver, partner) {}
  void begin(const LinkJob& job, Bytes data = {}) { cpu.begin(job, std::move(data), lines.now); }
  void run(unsigned ms) { cycles(lines, {&cpu}, ms); }
  // The partner acknowledges a command and answers with a block.
  void answers(std::string_view command, std::string_view reaction) {
    partner.expect("02").send("10").expect(command).send("10");
    partner.send("02").expect("10").send(reaction).expect("10");
  }
  // It sends a block and expects another one as reaction.
  void commands(std::string_view command, std::string_view reaction) {
    partner.send("02").expect("10").send(command).expect("10");
    partner.expect("02").send("10").expect(reaction).send("10");
  }

  Script partner;
  LinkCpu cpu;
  Coupled lines;
};

inline LinkJob sendJob(std::uint8_t block, std::uint16_t offset, std::uint16_t length) {
  return {.block = block, .offset = offset, .length = length};
}
inline LinkJob fetchJob(char type, std::uint8_t block, std::uint16_t offset, std::uint16_t length) {
  return {.fetch = true, .type = type, .block = block, .offset = offset, .length = length};
}

}  // namespace merker::serial
