// A project of several stations: its merker.toml names their folders, each an ordinary project, and
// the subnets between them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "address/connection_kind.h"
#include "project/dp_subnet.h"
#include "project/other_station.h"

namespace merker::project {

// Of one project: as many as fit into the memory of an ordinary computer.
constexpr std::size_t kMostStations = 1000;

// A station on a subnet.
struct SubnetNode {
  std::size_t station = 0;  // its number in the list of stations
  std::uint32_t address = 0;
  Position named;  // of the station
  bool grounded = true;
  std::string ip{};  // on Ethernet; its last number is the address
};

// A bus line between two terminating resistors (S7-NET-08).
struct Segment {
  std::uint32_t length = 0;         // metres
  std::vector<std::string> places;  // stations and repeaters in the order of the cable
};

enum class SubnetKind : std::uint8_t { Mpi, Ethernet };

struct Subnet {
  std::string name;
  SubnetKind kind = SubnetKind::Mpi;
  std::int64_t rate = 187'500;  // bits per second
  std::uint32_t highest = 31;   // MPI address (S7-NET-02)
  std::vector<SubnetNode> nodes{};
  std::vector<std::string> repeaters{};  // RS 485, each between two segments (S7-NET-09)
  std::vector<Segment> segments{};       // without any, nothing is known of the cable
};

// A packet of a GD circle (S7-NET-27). Operands as written: Press/MB 100:8.
struct GlobalDataRow {
  struct Place {
    std::string text;
    Position position;
  };
  std::uint32_t circle = 1, rate = 8;
  Position circleAt;
  Place from;
  std::vector<Place> to, status, groupStatus;
};

// A connection between two stations: of S7 communication (S7-NETPRO-08), or of their CP 343-1.
struct StationConnection {
  ConnectionKind kind = ConnectionKind::S7;
  std::uint16_t id = 1;                      // as blocks of `local` name it; `local` calls
  std::optional<std::uint16_t> partnerId{};  // the same of `partner`; none: it only serves
  std::size_t local = 0, partner = 0;        // numbers in the list of stations
  std::size_t subnet = 0;                    // number in the list of subnets
  Position position, localAt, partnerAt;
};

struct Network {
  std::vector<OtherStation> stations;
  std::vector<Subnet> subnets;
  std::vector<DpSubnet> profibus;
  std::vector<GlobalDataRow> globalData;
  std::vector<StationConnection> connections;
  bool plants = false;  // [[plant]]: read when the modules of the stations are known
};

// "Press, Belt", for problems; of many the first ones.
std::string stationNames(const Network& network);
// Its number in the list; case does not matter.
std::optional<std::size_t> findStation(const Network& network, std::string_view name);

}  // namespace merker::project
