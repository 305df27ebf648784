// Stations at a line for tests: what was on it, a partner that follows a script, two procedures.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "serial/ascii.h"
#include "serial/line.h"
#include "serial/procedure.h"

namespace merker::serial {

inline Bytes hex(std::string_view text) {
  Bytes bytes;
  const auto digit = [](char c) { return c <= '9' ? c - '0' : c - 'A' + 10; };
  for (std::size_t i = 0; i + 1 < text.size(); i += text[i] == ' ' ? 1 : 2)
    if (text[i] != ' ')
      bytes.push_back(static_cast<std::uint8_t>(digit(text[i]) * 16 + digit(text[i + 1])));
  return bytes;
}

inline std::string text(const Bytes& bytes) {
  std::string result;
  for (const std::uint8_t byte : bytes)
    result += fmt::format("{}{:02X}", result.empty() ? "" : " ", byte);
  return result;
}

inline Bytes counting(std::size_t count) {
  Bytes bytes(count);
  for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::uint8_t>(i);
  return bytes;
}

inline std::string number(std::optional<Event> event) {
  return event ? fmt::format("{:04X}", static_cast<unsigned>(*event)) : "none";
}

// A partner without a protocol: sends what a script says, when it has heard what it expects.
class Script : public Driver {
 public:
  Script& expect(std::string_view bytes) { return add({hex(bytes), {}, {}}); }
  Script& send(std::string_view bytes) { return add({{}, hex(bytes), {}}); }
  Script& send(Bytes bytes) { return add({{}, std::move(bytes), {}}); }
  Script& wait(std::int64_t ms) { return add({{}, {}, Duration::milliseconds(ms)}); }
  Script& expectAll(Bytes bytes) { return add({std::move(bytes), {}, {}}); }
  bool done() const { return steps_.empty() && out_.empty(); }

  std::vector<Character> heard;
  std::vector<std::pair<bool, Instant>> breaks;  // begins or ends

  void start(Instant) override {}
  void received(const Character& c) override {
    heard.push_back(c);
    recent_.push_back(c.value);
    now_ = c.at;
    go();
  }
  void interrupted(Instant at) override { breaks.emplace_back(true, at); }
  void restored(Instant at) override { breaks.emplace_back(false, at); }
  std::optional<std::uint8_t> next(Instant now) override {
    now_ = now;
    go();
    if (out_.empty()) return std::nullopt;
    const std::uint8_t value = out_.front();
    out_.pop_front();
    return value;
  }
  void sent(Instant at) override {
    now_ = at;
    go();
  }
  Instant due() const override { return until_; }
  void expire(Instant now) override {
    now_ = now;
    until_ = Instant::never();
    if (!steps_.empty()) steps_.pop_front();
    go();
  }

 private:
  struct Step {
    Bytes expected, sent;
    Duration pause;
  };
  Script& add(Step step) {
    steps_.push_back(std::move(step));
    return *this;
  }
  void go() {
    while (!steps_.empty() && out_.empty() && until_ == Instant::never()) {
      const Step& step = steps_.front();
      if (step.pause != Duration{}) {
        until_ = now_ + step.pause;
        return;
      }
      if (recent_.size() < step.expected.size()) return;
      if (!step.expected.empty()) {
        const Bytes got(recent_.begin(),
                        recent_.begin() + static_cast<std::ptrdiff_t>(step.expected.size()));
        EXPECT_EQ(text(got), text(step.expected));
        recent_.erase(recent_.begin(), recent_.begin() + static_cast<std::ptrdiff_t>(got.size()));
      }
      out_.insert(out_.end(), step.sent.begin(), step.sent.end());
      steps_.pop_front();
    }
  }
  std::deque<Step> steps_;
  std::deque<std::uint8_t> out_;
  Bytes recent_;
  Instant now_, until_ = Instant::never();
};

// Two stations, A and B, and everything they have sent.
class Coupled {
 public:
  Coupled(Driver& a, Driver& b, const Settings& ofA = {}, const Settings& ofB = {},
          bool twoWire = false)
      : line(twoWire) {
    line.join(a, ofA);
    line.join(b, ofB);
    for (std::size_t i = 0; i < 2; ++i)
      line.port(i).listen([this](const Sighting& s) {
        if (s.isCharacter()) seen.push_back(s);
      });
  }
  void run(std::int64_t ms) {
    poke();
    now = now + Duration::milliseconds(ms);
    line.advance(now);
  }
  void poke() { line.advance(now); }
  // "A 02 | B 10 | A 41": by the ends of the characters, and what came since the last call.
  std::string trace() {
    std::stable_sort(seen.begin(), seen.end(),
                     [](const Sighting& a, const Sighting& b) { return a.end < b.end; });
    std::string result;
    std::size_t port = 9;
    for (const Sighting& s : seen) {
      if (s.port != port) result += fmt::format("{}{}", port == 9 ? "" : " | ", "AB"[s.port]);
      port = s.port;
      result += fmt::format(" {:02X}", s.value);
    }
    seen.clear();
    return result;
  }

  Line line;
  Instant now;
  std::vector<Sighting> seen;
};

inline ProcedureParameters low() {
  ProcedureParameters parameters;
  parameters.highPriority = false;
  return parameters;
}

// Two CPUs with 3964(R): A has high, B low priority.
class Procedures {
 public:
  explicit Procedures(const ProcedureParameters& ofA = {}, const ProcedureParameters& ofB = low(),
                      const Settings& settings = {})
      : a(ofA, mailA), b(ofB, mailB), lines(a, b, settings, settings) {}
  void send(const Bytes& data) { a.send(data, lines.now); }
  std::string endOfA() { return number(a.outbox().takeEnd()); }
  std::string endOfB() { return number(b.outbox().takeEnd()); }

  Mailbox mailA, mailB;
  Procedure a, b;
  Coupled lines;
};

// A CPU with 3964(R) and a partner with a script.
class Scripted {
 public:
  explicit Scripted(const ProcedureParameters& parameters = {}, const Settings& settings = {})
      : cpu(parameters, mail), lines(cpu, partner, settings, settings) {}
  void send(const Bytes& data) { cpu.send(data, lines.now); }
  std::string end() { return number(cpu.outbox().takeEnd()); }
  // Telegrams and events, oldest first: "41 42; 0806".
  std::string mailbox() {
    std::string result;
    while (const auto entry = mail.take())
      result += (result.empty() ? "" : "; ") +
                (entry->event == Event::None ? text(entry->telegram) : number(entry->event));
    return result;
  }

  Mailbox mail;
  Procedure cpu;
  Script partner;
  Coupled lines;
};

}  // namespace merker::serial
