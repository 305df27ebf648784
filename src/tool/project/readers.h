// The parts of merker.toml, each read by its own file.
#pragma once

#include "project/settings.h"
#include "project/table.h"

namespace merker::project {

// [cpu] without model and clock: CpuParameters (S7-HWCFG-08)
// `protection` and `password`, of [cpu] or [communication].
void readProtection(const Table& table, CpuParameters& parameters);
void readCpuParameters(const Table& cpu, const CpuModel& model, CpuParameters& parameters);
// A date and time as DT# in milliseconds since 1990-01-01.
std::optional<std::int64_t> readDateAndTime(const Table& table, std::string_view key);

// What only a SINUMERIK has: [machine_data], [plc], [alarm_texts], [nc] (S5-MD, S5-ERR-04, OP-55)
void readControl(const Table& root, cnc::Options& options);
// [nc]: what the NC side holds at the start
void readNc(const Table& nc, nc::Control& control);

// 4, 2.2 or "2.2" as text; empty if it is nothing like it.
std::string slotText(const toml::node& node);
// [[module]]; nothing if it is too wrong to have a place
std::optional<io::Module> readModule(const Table& table, const CpuModel& model);
// [[plant]] and its wires to the modules
plant::Configuration readPlants(const Table& root, const io::Configuration& modules);
// The module's parameters (S7-HWCFG-09)
void readParameters(const Table& table, io::Module& module);
// slave of a CP 343-2
void readAsiSlaves(const Table& table, io::Module& module);
// web of a CP 343-1 IT
void readCpWeb(const Table& table, io::Module& module);
// [[module.channel]]
void readChannels(const Table& table, io::Module& module);
// interrupts, [[module.channel]] of the sub-module 2.4
void readInterruptSelection(const Table& table, io::Module& module);
void readCounters(const Table& table, const CpuModel& model, io::Module& module);
// drive and what belongs to it, of the sub-module 2.5; then what it needs of others (POS-PARAM)
void readAxis(const Table& table, io::Module& module);
void checkAxis(const Table& root, const io::Configuration& configuration);
// [module.serial] of the sub-module 2.1 (PTP-PARAM)
void readSerial(const Table& table, const CpuModel& model, io::Module& module);
// [serial]: what X27 is connected to (PTP-LINE-12)
std::optional<serial::Connection> readConnection(const Table& root);
// [serial] pacing
void readPacing(const Table& root, io::Configuration& configuration);
// [communication]; of a SINUMERIK as if it had the connections of a CPU 314C-2
// `hasProtection`: the CPU has protection levels, which stand here or in [cpu].
CommunicationParameters readCommunication(const Table& root, const CpuModel& model,
                                          bool hasProtection);
void readCommunicationProtection(const Table& root, CpuParameters& parameters);
// [[connection]]: configured S7 connections, of those that [communication] has
void readConfigured(const Table& root, CommunicationParameters& parameters);
// A [[connection]] of a CP 343-1, of `kind`, which is not S7, behind those that there are.
void readCpConnection(const Table& table, ConnectionKind kind, CommunicationParameters& parameters);
// `kind` of a [[connection]].
ConnectionKind readConnectionKind(const Table& table);
// The ID of a connection of a CP 343-1; nothing, and a problem: it is none.
std::optional<std::uint8_t> readCpId(const Table& table, std::string_view key);
// What is special to one that sends e-mails.
void readCpMail(const Table& table, CpConnectionParameters& connection);
void requireItCp(const Table& root, const Settings& settings);
// Connections of a CP need one.
void requireCp(const Table& root, const Settings& settings);
// Whose blocks the program may call.
Libraries readLibraries(const Table& root, const Settings& settings);
// "W#16#1" or 1; nothing, and a problem, if it is no local ID
std::optional<std::uint16_t> readConnectionId(const Table& table, std::string_view key);
// [[connection]] between two stations of a project of several
void readStationConnections(const Table& root, Network& network);
// A [[station]]; nothing if its name or folder is wrong
std::optional<OtherStation> readStation(const Table& table);
// Whether it is the project of several stations; then what it says of them
bool namesOnlyStations(const Table& root);
Network readNetwork(const Table& root);
// [[subnet]] and its nodes
void readSubnets(const Table& root, Network& network);
// Of all [[subnet]]s: each has its own
void checkSubnetNames(const Table& root);
// Repeaters and segments of a [[subnet]] whose nodes are known
void readSegments(const Table& table, const Network& network, Subnet& subnet);
// [[subnet]] of PROFIBUS with its [[slave]]s; `network` null: of a project of one station
bool isDpSubnet(const Table& table);
std::vector<DpSubnet> readDpSubnets(const Table& root, const Network* network);
// False: one of them is too wrong to be there. `allSubnets`: none is missing because of a mistake.
bool readSlaves(const Table& root, const Network* network, std::vector<DpSubnet>& subnets,
                bool allSubnets);
// A [[slave]] that is another station, with its areas; false and a problem: it cannot be one
bool readIntelligentSlave(const Table& table, const Network* network,
                          const std::vector<DpSubnet>& subnets, DpSubnet& subnet, io::Slave& slave);
// [[global_data]]
void readGlobalData(const Table& root, Network& network);
// [[station]] of a station: another one, which X27 must be connected to
std::vector<OtherStation> readStations(const Table& root,
                                       const std::optional<serial::Connection>& serial);
// "±10V, 0..10V, …": the ranges of a RangeSet, for problems
std::string rangeNames(std::uint16_t sets);

}  // namespace merker::project
