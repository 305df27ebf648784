// Reads [[plant]] of merker.toml. Of a project of several stations a plant belongs to one of them,
// and its wires may end at terminals of the others.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "io/rack.h"
#include "plant/telegram.h"
#include "project/station_plants.h"
#include "project/table.h"

namespace merker::project {

// "the binary input signal UP", for problems.
std::string titleOf(const plant::Signal& signal);

// Reads the plants of one station, in the order of the file.
class PlantReader {
 public:
  // Adds to `plants`. `stations`: where wires may end, too; it is one of them.
  PlantReader(const io::Configuration& modules, plant::Configuration& plants,
              std::vector<StationField>* stations = nullptr, std::size_t own = 0)
      : rack_(modules), plants_(plants), stations_(stations), own_(own) {}
  // All names, in capital letters, of each station, to tell which of them stand below or elsewhere.
  void expect(const std::vector<std::set<std::string>>& names) { expected_ = &names; }
  // Names of plants, in capital letters, that no station has because of a mistake.
  void refuse(const std::set<std::string>& names) { refused_.insert(names.begin(), names.end()); }
  void read(const Table& table);

 private:
  using Settings = plant::PlantSettings;
  bool readName(const Table& table, Settings& plant) const;
  void readWires(const Table& wires, Settings& plant);
  void readWire(const Table& wires, const std::string& key, Settings& plant);
  void readBus(const Table& wires, std::string_view key, Settings& plant) const;
  std::optional<std::uint32_t> slaveModule(std::string_view slave,
                                           const plant::Telegram& telegram) const;
  // The wire of a signal, and where it is written.
  struct Asked {
    const Table& table;
    std::string_view key;
    const Settings& plant;
    const plant::Signal& signal;
    const Table* ends;  // { to, low, high }; null: the end alone
  };
  bool find(const Asked& asked, plant::Wire& wire);
  bool cannotFeed(const Asked& asked, std::string_view front, const plant::Wire& wire) const;
  bool isNamed(std::size_t station, std::string_view plant) const;
  bool isOfOthers(const Asked& asked, std::optional<std::size_t> station, std::string_view front,
                  const plant::Wire& wire) const;
  bool isStrange(const Asked& asked, std::string_view end) const;
  bool findSignal(const Asked& asked, std::uint32_t other, plant::Wire& wire) const;
  bool findHere(const Asked& asked, std::string_view end, plant::Wire& wire) const;
  bool findThere(const Asked& asked, std::size_t station, std::string_view end, plant::Wire& wire);
  std::optional<std::size_t> otherStation(std::string_view& end) const;

  io::Rack rack_;
  plant::Configuration& plants_;
  std::vector<StationField>* stations_;
  std::size_t own_;
  const std::vector<std::set<std::string>>* expected_ = nullptr;
  std::set<std::string> refused_;  // plants that are too wrong to be there, in capital letters
};

}  // namespace merker::project
