// The GD table of a project: its operands, bound to the stations, and the limits of a CPU 31xC
// (S7-NET-27, S7-LIM-02).
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "base/text.h"
#include "compilation/network.h"

namespace merker::compilation {
namespace {

using network::GlobalArea;
using network::GlobalPacket;
using project::GlobalDataRow;

// Packets that a CPU 31xC sends, and as many that it takes (CPU 31xC and 31x: Technical Data, 3.2).
constexpr std::size_t kMostPackets = 4;
constexpr std::uint32_t kStatusBytes = 4;

struct StationArea {
  std::size_t station = 0;
  GlobalArea area;
  bool counted = false;  // with :8
};

class GlobalTable {
 public:
  explicit GlobalTable(NetworkBuild& build)
      : build_(build), operands_(build), resolver_(operands_.resolver(std::nullopt)) {
    result.resize(build.stations.size());
  }

  void add(const GlobalDataRow& row) {
    const auto from = area(row.from);
    if (!from) return;
    if (from->area.length > network::kLongestPacket)
      return refuse(row.from, fmt::format("at most {} bytes long", network::kLongestPacket));
    GlobalPacket packet{static_cast<std::uint8_t>(row.circle), ++packets_[row.circle], true,
                        from->area, row.rate};
    put(row, row.from, from->station, packet);
    const std::size_t before = build_.problems.list().size();
    for (const GlobalDataRow::Place& place : row.to) addReceiver(row, *from, packet, place);
    if (build_.problems.list().size() > before) return;  // who is in the circle is not known
    for (const GlobalDataRow::Place& place : row.groupStatus)
      if (const auto status = statusArea(place); status && inCircle(row, *status, place))
        result[status->station].groupStatus = status->area;
    for (const GlobalDataRow::Place& place : row.status)
      if (const auto known = statuses_.find(&place); known != statuses_.end() && known->second)
        inCircle(row, *known->second, place);
  }

  std::vector<network::GlobalData> result;

 private:
  void refuse(const GlobalDataRow::Place& place, std::string_view what) {
    build_.problems.add(ProblemCode::P0704, place.position, place.text, what);
  }

  // "MB 100:8"; nothing, and a problem, if it is no area of global data.
  std::optional<StationArea> area(const GlobalDataRow::Place& place) {
    std::string_view text = place.text;
    std::uint32_t count = 1;
    const auto colon = text.rfind(':');
    if (colon != std::string_view::npos) {
      const std::string_view digits = trim(text.substr(colon + 1));
      const auto [end, error] =
          std::from_chars(digits.data(), digits.data() + digits.size(), count);
      if (error != std::errc() || end != digits.data() + digits.size() || count == 0) {
        refuse(place, "written with a whole number behind the colon: MB 100:8");
        return std::nullopt;
      }
      text = trim(text.substr(0, colon));
    }
    const auto reference = resolver_(text, place.position);
    if (!reference) {
      build_.problems.add(reference.error());
      return std::nullopt;
    }
    const address::Operand& operand = reference->operand;
    const bool areas = operand.area == Area::Input || operand.area == Area::Output ||
                       operand.area == Area::Flag || operand.area == Area::DataBlock;
    if (!address::isMemory(operand) || !areas || operand.width == Width::Bit ||
        reference->bytes > 0) {
      refuse(place, "a byte, word or double word of E, A, M or a data block: MB 100:8");
      return std::nullopt;
    }
    const auto db = static_cast<std::uint16_t>(std::max(0, reference->db));
    const std::uint32_t length =
        count > network::kLongestPacket ? count : count * byteCount(operand.width);
    return StationArea{reference->station - 1u,
                       {operand.area, db, operand.value / 8, length},
                       colon != std::string_view::npos};
  }

  std::optional<StationArea> statusArea(const GlobalDataRow::Place& place) {
    auto found = area(place);
    if (found && found->area.length == kStatusBytes) return found;
    if (found) refuse(place, "a double word: Belt/MD 120");
    return std::nullopt;
  }

  // A station that neither sends nor takes a packet of the circle has no status of it.
  bool inCircle(const GlobalDataRow& row, const StationArea& status,
                const GlobalDataRow::Place& place) {
    const auto& packets = result[status.station].packets;
    if (std::ranges::any_of(packets,
                            [&](const GlobalPacket& one) { return one.circle == row.circle; }))
      return true;
    refuse(place, "of a station that sends or takes this packet");
    return false;
  }

  // The double word for the status of this packet in this station.
  std::optional<GlobalArea> statusOf(const GlobalDataRow& row, std::size_t station) {
    for (const GlobalDataRow::Place& place : row.status) {
      const auto known = statuses_.find(&place);
      const auto status = known != statuses_.end() ? known->second : statusArea(place);
      statuses_.emplace(&place, status);
      if (status && status->station == station) return status->area;
    }
    return std::nullopt;
  }

  void addReceiver(const GlobalDataRow& row, const StationArea& from, GlobalPacket packet,
                   const GlobalDataRow::Place& place) {
    auto to = area(place);
    if (!to) return;
    if (!to->counted) to->area.length = from.area.length;
    if (to->area.length != from.area.length)
      return refuse(place, fmt::format("{} bytes long, as the sender's area", from.area.length));
    if (to->station == from.station) return refuse(place, "of another station than the sender's");
    if (subnetOf(to->station) == nullptr || subnetOf(to->station) != subnetOf(from.station))
      return refuse(place, "of a station on the MPI subnet of the sender");
    packet.sends = false;
    packet.data = to->area;
    put(row, place, to->station, packet);
  }

  const project::Subnet* subnetOf(std::size_t station) const {
    for (const project::Subnet& subnet : build_.project.network->subnets) {
      if (subnet.kind != project::SubnetKind::Mpi) continue;
      for (const project::SubnetNode& node : subnet.nodes)
        if (node.station == station) return &subnet;
    }
    return nullptr;
  }

  // A CPU sends one packet of a circle and takes one.
  void put(const GlobalDataRow& row, const GlobalDataRow::Place& place, std::size_t station,
           GlobalPacket packet) {
    packet.status = statusOf(row, station);
    auto& list = result[station].packets;
    const auto alike = [&](const GlobalPacket& one) { return one.sends == packet.sends; };
    const auto same = [&](const GlobalPacket& one) {
      return alike(one) && one.circle == packet.circle;
    };
    const std::string_view does = packet.sends ? "sends" : "takes";
    if (std::ranges::any_of(list, same))
      return refuse(place, fmt::format("in another circle: {} {} one packet of a circle",
                                       build_.stations[station].name, does));
    if (static_cast<std::size_t>(std::ranges::count_if(list, alike)) == kMostPackets)
      return refuse(place, fmt::format("left out: {} {} {} packets at most",
                                       build_.stations[station].name, does, kMostPackets));
    list.push_back(packet);
  }

  NetworkBuild& build_;
  NetworkOperands operands_;
  simulator::Resolver resolver_;
  std::map<std::uint32_t, std::uint8_t> packets_;  // of each circle
  std::map<const GlobalDataRow::Place*, std::optional<StationArea>> statuses_;
};

}  // namespace

std::vector<network::GlobalData> globalDataOf(NetworkBuild& build) {
  if (build.project.network->globalData.empty())
    return std::vector<network::GlobalData>(build.stations.size());
  GlobalTable table(build);
  for (const GlobalDataRow& row : build.project.network->globalData) table.add(row);
  return std::move(table.result);
}

}  // namespace merker::compilation
