#include "s7_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <mutex>
#include <set>
#include <thread>

#include "cp_sockets.h"
#include "cp_web.h"
#include "ethernet.h"
#include "s7_calls.h"
#include "server/guard.h"

namespace merker::app {

namespace net = boost::asio;
using net::ip::tcp;

namespace {

// Sockets at the same time: the connections of a CPU, and some that have not asked for one yet.
constexpr std::size_t kMoreSockets = 52;
constexpr std::size_t kMostSockets = 512;  // for unlimited connections
constexpr std::chrono::milliseconds kBetweenChecks(250);

// Who has got an answer usually asks again at once. To be awake when it does saves putting the
// thread to sleep and waking it, which takes longer than the answer. Where the client needs the
// only core, it would have to wait.
constexpr std::chrono::microseconds kStaysAwake(20);

void work(net::io_context& context) {
  const bool spare = std::thread::hardware_concurrency() > 1;
  while (!context.stopped() && context.run_one() > 0) {
    if (!spare) continue;
    auto until = S7Connection::Clock::now() + kStaysAwake;
    while (S7Connection::Clock::now() < until)
      if (context.poll() > 0) until = S7Connection::Clock::now() + kStaysAwake;
  }
}

std::string plural(std::uint64_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

// The clients go before what they share, and the calls that wait for the thread with them.
struct S7Server::Parts {
  explicit Parts(S7Place wanted) : place(std::move(wanted)) {
    around.makeRoom = [this](served::Resource kind) {
      return breakOffNew([kind](const S7Connection& client) { return client.holds(kind); });
    };
  }

  S7Place place;
  S7Surroundings around;
  net::io_context context{1};
  tcp::acceptor acceptor{context};
  net::steady_timer timer{context}, pause{context};
  std::set<std::shared_ptr<S7Connection>> clients;
  S7Calls calls{context, around, !hmi::isLocalAddress(place.address)};
  CpSockets cp{context, around.exchange.cpLines(), place.address};
  CpWeb web{context, around.exchange, place.address};
  std::thread thread;
  mutable std::mutex outsideMutex;
  workbench::S7Outside outside;

  void tell();
  bool listen(std::string& reason);
  void accept();
  void acceptLater();
  void take(tcp::socket socket, iso::View sent = {}, const S7WayOpen& way = {});
  bool makeRoom();
  bool breakOffNew(const std::function<bool(const S7Connection&)>& helps);
  void check();
  void use(const CommunicationParameters& parameters);
  void callPartners();
};

bool S7Server::Parts::listen(std::string& reason) {
  boost::system::error_code error;
  const tcp::endpoint endpoint(net::ip::make_address(place.address), place.port);
  acceptor.open(endpoint.protocol(), error);
  if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor.bind(endpoint, error);
  if (!error) acceptor.listen(tcp::acceptor::max_listen_connections, error);
  if (!error) place.port = acceptor.local_endpoint(error).port();
  if (error)
    reason = fmt::format("--s7: port {} of {} cannot be used: {}", place.port, place.address,
                         error.message());
  return !error;
}

void S7Server::Parts::accept() {
  acceptor.async_accept([this](boost::system::error_code error, tcp::socket socket) {
    if (error == net::error::operation_aborted) return;
    if (error) return acceptLater();
    take(std::move(socket));
    accept();
  });
}

// The process has no more descriptors, say: whoever waits goes on waiting.
void S7Server::Parts::acceptLater() {
  pause.expires_after(kBetweenChecks);
  pause.async_wait([this](boost::system::error_code error) {
    if (!error) accept();
  });
}

// False: every socket belongs to a client that has set up its connection.
bool S7Server::Parts::makeRoom() {
  std::erase_if(clients, [](const auto& client) { return client->closed(); });
  const auto& connections = around.parameters.connections;
  if (clients.size() < (connections ? *connections + kMoreSockets : kMostSockets)) return true;
  return breakOffNew([](const S7Connection&) { return true; });
}

// Of those that have not set up their connection the one that has waited longest goes: nobody keeps
// others out by saying nothing.
bool S7Server::Parts::breakOffNew(const std::function<bool(const S7Connection&)>& helps) {
  const auto goes = [&](const auto& one) { return !one->closed() && one->isNew() && helps(*one); };
  const auto oldest = std::ranges::min_element(clients, {}, [&](const auto& client) {
    return goes(client) ? client->due() : S7Connection::Clock::time_point::max();
  });
  if (oldest == clients.end() || !goes(*oldest)) return false;
  (*oldest)->breakOff(S7Why::MadeRoom);
  return true;
}

void S7Server::Parts::take(tcp::socket socket, iso::View sent, const S7WayOpen& way) {
  if (!around.exchange.reachable()) return around.incidents.note(addressOf(socket), S7Why::NoPower);
  if (!makeRoom()) {
    around.incidents.note(addressOf(socket), S7Why::NoSocket);
    return;
  }
  const auto client = std::make_shared<S7Connection>(std::move(socket), around);
  clients.insert(client);
  client->begin(sent, way);
}

// Time limits, and those that have gone.
void S7Server::Parts::check() {
  timer.expires_after(kBetweenChecks);
  timer.async_wait([this](boost::system::error_code error) {
    if (error) return;
    const auto now = S7Connection::Clock::now();
    for (const auto& client : clients) {
      if (!client->closed() && client->overdue(now)) client->breakOffLate();
      if (!client->closed() && (client->cutOff() || !around.exchange.reachable())) client->close();
    }
    std::erase_if(clients, [](const auto& client) { return client->closed(); });
    callPartners();
    cp.look(around.exchange.reachable());
    web.look(around.exchange.reachable());
    tell();
    check();
  });
}

void S7Server::Parts::callPartners() {
  if (!around.exchange.reachable()) return;
  calls.look(S7Connection::Clock::now(), [this](auto call) { clients.insert(std::move(call)); });
}

// Partners of connections that another project has configured go.
void S7Server::Parts::use(const CommunicationParameters& parameters) {
  for (const auto& client : clients)
    if (client->configured()) client->close();
  calls.forget();
  around.use(parameters);
  cp.use(parameters.ofCp);
  cp.look(around.exchange.reachable());
  web.use(parameters.web);
  callPartners();
}

void S7Server::Parts::tell() {
  const auto now = S7Connection::Clock::now();
  const CommunicationParameters& set = around.parameters;
  const S7Counts& counts = around.incidents.counts;
  workbench::S7Outside told{.connections = set.connections,
                            .pg = set.pg,
                            .op = set.op,
                            .basic = set.basic,
                            .confirmed = counts.connections,
                            .refused = counts.refused,
                            .broken = counts.broken,
                            .requests = counts.requests,
                            .denied = counts.denied,
                            .refusals = around.incidents.rows(now)};
  for (const auto& client : clients)
    if (auto row = client->row(now)) told.clients.push_back(std::move(*row));
  told.partners = calls.rows();
  told.ofCp = cp.rows();
  const std::lock_guard lock(outsideMutex);
  outside = std::move(told);
}

std::unique_ptr<S7Server> S7Server::start(const S7Place& place,
                                          const CommunicationParameters& parameters,
                                          std::function<void()> wake, std::string& reason) {
  auto parts = std::make_unique<Parts>(place);
  if (!parts->listen(reason)) return nullptr;
  parts->around.exchange.connectBy(
      [context = &parts->context](served::Exchange::Call call) {
        net::post(*context, std::move(call));
      },
      std::move(wake));
  parts->use(parameters);
  parts->around.exchange.reachedBy(ethernetAt(parts->place.address));
  parts->accept();
  parts->tell();
  parts->check();
  parts->thread = std::thread([context = &parts->context] { work(*context); });
  return std::unique_ptr<S7Server>(new S7Server(std::move(parts)));
}

S7Server::S7Server(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

S7Server::~S7Server() {
  parts_->context.stop();
  parts_->thread.join();
  for (const auto& client : parts_->clients) client->close();
}

void S7Server::use(const CommunicationParameters& parameters) {
  net::post(parts_->context, [parts = parts_.get(), parameters] { parts->use(parameters); });
}

// In its own thread: what has called is already the other server's.
void S7Server::passOn(std::map<std::uint8_t, S7Way> others) {
  net::post(parts_->context, [parts = parts_.get(), others = std::move(others)] {
    parts->around.passOn = {};
    if (others.empty()) return;
    parts->around.passOn = [others](tcp::socket& client, iso::View called, iso::View sent) {
      constexpr std::size_t kTsap = 2;
      const auto found = called.size() == kTsap ? others.find(called[1]) : others.end();
      if (found == others.end()) return S7Whose::Own;
      const S7Way& way = found->second;
      if (!*way.open) return S7Whose::NoWay;
      boost::system::error_code error;
      const bool six = client.local_endpoint(error).address().is_v6();
      const int descriptor = client.release(error);
      if (!error) way.server->adopt(descriptor, six, {sent.begin(), sent.end()}, way.open);
      return S7Whose::Passed;
    };
  });
}

void S7Server::adopt(int descriptor, bool six, const iso::Bytes& sent, const S7WayOpen& way) {
  net::post(parts_->context, [parts = parts_.get(), descriptor, six, sent, way] {
    tcp::socket client(parts->context);
    boost::system::error_code error;
    client.assign(six ? tcp::v6() : tcp::v4(), descriptor, error);
    if (!error) parts->take(std::move(client), sent, way);
  });
}

served::Exchange& S7Server::exchange() { return parts_->around.exchange; }

workbench::S7Outside S7Server::outside() const {
  std::unique_lock lock(parts_->outsideMutex);
  workbench::S7Outside told = parts_->outside;
  lock.unlock();
  told.place = place();
  told.warning = warning();
  return told;
}

std::string S7Server::place() const {
  const bool six = parts_->place.address.find(':') != std::string::npos;
  return fmt::format("{}{}{}:{}", six ? "[" : "", parts_->place.address, six ? "]" : "",
                     parts_->place.port);
}

std::string S7Server::summary() const {
  const S7Counts& counts = parts_->around.incidents.counts;
  const std::uint64_t denied = counts.denied;
  return fmt::format("{}, {} refused, {} broken off, {}{}",
                     plural(counts.connections, "connection"), counts.refused.load(),
                     counts.broken.load(), plural(counts.requests, "request"),
                     denied > 0 ? fmt::format(", {} denied", denied) : std::string());
}

std::string S7Server::warning() const {
  if (hmi::isLocalAddress(parts_->place.address)) return {};
  return "S7 communication has no encryption: whoever reaches " + place() +
         " can read and change this PLC";
}

}  // namespace merker::app
