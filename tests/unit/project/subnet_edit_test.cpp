// S7-NETPRO-03, -04, -06: the network view changes merker.toml, and nothing but what it means.
#include "project/subnet_edit.h"

#include <gtest/gtest.h>

namespace merker::project {
namespace {

constexpr const char* kText = R"toml([project]
name = "Lab"

# the long cable
[[subnet]]
name = "MPI(1)"
kind = "MPI"
nodes = [
  {station = "Press", address = 2, grounded = false}, # the first one
  {station = "Belt", address = 3},
]

[[subnet]]
kind = "ethernet"
nodes = [{station = "Press", address = "192.168.0.1"}]

[[global_data]]
circle = 1
)toml";

std::string with(std::string_view old, std::string_view fresh) {
  std::string text = kText;
  const auto at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), fresh);
}

std::string after(std::string_view subnet, std::string_view station, std::string_view address) {
  SubnetEdit edit(kText);
  edit.setNode(subnet, station, address);
  return edit.text();
}

TEST(SubnetEdit, AStationChangesItsAddressOnly) {
  EXPECT_EQ(after("MPI(1)", "press", "5"), with("address = 2", "address = 5"));
  EXPECT_EQ(after("Ethernet", "Press", "192.168.0.9"), with("0.1", "0.9"));
}

TEST(SubnetEdit, AStationIsConnected) {
  EXPECT_EQ(after("MPI(1)", "Saw", "4"),
            with("address = 3}", "address = 3}, {station = \"Saw\", address = 4}"));
  EXPECT_EQ(after("Ethernet", "Belt", "192.168.0.2"),
            with("0.1\"}", "0.1\"}, {station = \"Belt\", address = \"192.168.0.2\"}"));
  EXPECT_EQ(after("PROFIBUS(1)", "Saw", "4"), kText);
}

TEST(SubnetEdit, AStationLeaves) {
  EXPECT_EQ(after("MPI(1)", "Press", ""),
            with("{station = \"Press\", address = 2, grounded = false}, # the first one\n  ", ""));
  EXPECT_EQ(after("Ethernet", "Press", ""),
            with("{station = \"Press\", address = \"192.168.0.1\"}", ""));
  EXPECT_EQ(after("MPI(1)", "Saw", ""), kText);
}

// Whatever is taken out, the file can still be read and changed.
TEST(SubnetEdit, WhoLeftMayComeBack) {
  SubnetEdit edit(kText);
  edit.setNode("MPI(1)", "Belt", "");
  edit.setNode("MPI(1)", "Press", "");
  EXPECT_EQ(edit.subnetsOf("Belt", "mpi"), std::vector<std::string>());
  edit.setNode("MPI(1)", "Belt", "7");
  edit.setNode("MPI(1)", "Press", "8");
  EXPECT_EQ(edit.subnetsOf("Belt", "mpi"), std::vector<std::string>{"MPI(1)"});
  EXPECT_EQ(edit.subnetsOf("press", "mpi"), std::vector<std::string>{"MPI(1)"});
  EXPECT_EQ(edit.subnetsOf("Belt", "ethernet"), std::vector<std::string>());
}

TEST(SubnetEdit, PropertiesOfASubnet) {
  SubnetEdit edit(kText);
  EXPECT_EQ(edit.kindOf("MPI(1)"), "mpi");
  EXPECT_EQ(edit.kindOf("Ethernet"), "ethernet");
  EXPECT_EQ(edit.kindOf("MPI"), "");
  edit.set("MPI(1)", "kind", "\"mpi\"");
  edit.set("Ethernet", "baud", "\"10M\"");
  edit.remove("MPI(1)");
  EXPECT_EQ(edit.text(),
            "[project]\nname = \"Lab\"\n\n[[subnet]]\nkind = \"ethernet\"\nnodes = [{station = "
            "\"Press\", address = \"192.168.0.1\"}]\nbaud = \"10M\"\n\n[[global_data]]\ncircle = "
            "1\n");
}

}  // namespace
}  // namespace merker::project
