// Several stations that move through one virtual time. Each advances by itself through a window of
// time in which no other one can reach it; what they have sent is carried between two windows, in
// the order of virtual time. So neither threads nor the length of windows change what comes out.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "network/subnet.h"
#include "network/workers.h"
#include "plc/controller.h"

namespace merker::network {

struct Station {
  std::string name;
  std::unique_ptr<controller::Controller> plc;
};

class Network {
 public:
  explicit Network(std::vector<Station> stations, unsigned threads = 1);
  ~Network();
  Network(const Network&) = delete;
  Network& operator=(const Network&) = delete;

  // Station `i` is a node of the MPI subnet from now on. It can be one.
  void join(std::size_t i, Subnet& subnet, std::uint8_t address, const GlobalData& globalData = {});
  // The same on PROFIBUS-DP, with its DP interface.
  void joinDp(std::size_t i, Subnet& subnet, std::uint8_t address);
  // The same on an Ethernet: only configured connections use it.
  void attach(std::size_t i, Subnet& subnet, std::uint8_t address);
  // Plants of the first station are wired to terminals of the second.
  void wire(std::size_t plants, std::size_t terminals);
  struct Partner {
    std::size_t station = 0;
    std::optional<std::uint16_t> id{};  // as ConnectionEnd
  };
  // A configured connection; both are on the subnet.
  void connect(const Subnet& subnet, const Partner& calling, const Partner& called,
               ConnectionKind kind = ConnectionKind::S7);
  Subnet& addSubnet(const Medium& medium, std::string name = {});
  Subnet& addSubnet(std::int64_t rate, std::string name = {}) {
    return addSubnet(mpi(rate), std::move(name));
  }
  // By name; case does not matter. Null: there is none.
  Subnet* subnet(std::string_view name);
  // Of a station on this subnet; nothing if it is not on it.
  std::optional<std::uint8_t> addressOf(std::size_t station, const Subnet& subnet) const;
  std::optional<std::size_t> find(std::string_view station) const;

  std::size_t size() const { return stations_.size(); }
  const std::string& name(std::size_t i) const { return stations_[i].name; }
  // The station as a PLC that takes the others along through time.
  controller::Controller& station(std::size_t i);
  // The station itself: for its values, never to move it.
  controller::Controller& itself(std::size_t i) { return *stations_[i].plc; }

  // Up to here all have moved.
  Instant now() const { return now_; }
  void advanceTo(Instant t);
  // As the functions of Controller, of the station `i`; the others come along.
  bool advanceToCheckpoint(std::size_t i, Instant limit);
  bool settle(std::size_t i, Duration longest);
  void advanceCycles(std::size_t i, std::uint64_t count);
  // Each to the end of the cycle that it is in. False: not all within `longest`.
  bool settle(Duration longest);

 private:
  void othersTo(std::size_t i, Instant end);
  void close(Instant end);
  Instant windowEnd(Instant wanted) const;
  bool inUse(const Subnet& subnet) const;

  struct Place {
    std::size_t station = 0;
    const Subnet* subnet = nullptr;
    Node* node = nullptr;
  };
  const Place* placeOf(std::size_t station, const Subnet& subnet) const;
  std::vector<Place> places_;
  std::uint16_t connections_ = 0;
  std::vector<std::unique_ptr<Subnet>> subnets_;  // they outlive the stations
  std::vector<Station> stations_;
  std::vector<std::unique_ptr<controller::Controller>> members_;
  Workers workers_;
  Instant now_;
};

}  // namespace merker::network
