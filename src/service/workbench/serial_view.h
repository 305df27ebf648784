// The line of X27 as browsers see it: each character with its time and what it means (PTP-LINE-11),
// decoded once for all of them. Only the last characters are kept; nothing happens while nobody
// looks.
#pragma once

#include <deque>
#include <optional>
#include <string>

#include "serial/coupling.h"
#include "serial/decoder.h"
#include "workbench/json.h"

namespace merker::workbench {

// What the interface is connected to outside of the simulation, as the program around says it.
struct SerialOutside {
  std::string connection;  // as in merker.toml; empty: the partner of the simulation
  std::string place;       // where that is: "/dev/pts/3", "127.0.0.1:4000"
  bool connected = false;
  std::string problem;  // why it could not be opened
};

class SerialView {
 public:
  static constexpr std::size_t kMostRows = 4'000;  // kept
  static constexpr std::size_t kMostTold = 1'000;  // at a time to a browser

  // Takes what is new on the line. Of a long time only the last characters are decoded.
  void look(const serial::Coupling& coupling);
  // The number behind the last row.
  std::uint64_t end() const { return next_; }
  // [[from, character, name, meaning, begin, end], ...] from this number on; it moves behind them.
  Json rows(std::uint64_t& from) const;

 private:
  struct Row {
    serial::Sighting sighting;
    std::string meaning;
  };
  std::optional<serial::Decoder> decoder_;
  std::deque<Row> rows_;
  std::uint64_t next_ = 0;
};

// Settings and state of the line: what is connected, who is there.
Json serialLine(serial::Coupling& coupling, const SerialOutside& outside);

}  // namespace merker::workbench
