// Changes of the subnets in the merker.toml of several stations, as the network view makes them
// (S7-NETPRO-03, -04, -06). Comments and order of the file stay.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace merker::project {

class SubnetEdit {
 public:
  explicit SubnetEdit(std::string text) : text_(std::move(text)) {}

  const std::string& text() const { return text_; }

  // "mpi", "ethernet", "profibus"; empty: there is no [[subnet]] of this name.
  std::string kindOf(std::string_view subnet) const;
  // Subnets of this kind that the station is on.
  std::vector<std::string> subnetsOf(std::string_view station, std::string_view kind) const;
  // "3", "192.168.0.3": where it is on the subnet from now on; empty: nowhere.
  void setNode(std::string_view subnet, std::string_view station, std::string_view address);
  // A key of the [[subnet]], its value as TOML.
  void set(std::string_view subnet, std::string_view key, const std::string& value);
  // With its slaves.
  void remove(std::string_view subnet);

 private:
  std::string text_;
};

}  // namespace merker::project
