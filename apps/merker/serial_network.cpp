#include "serial_network.h"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "com_port.h"
#include "serial_file.h"

namespace merker::app {
namespace {

constexpr std::size_t kNetworkChunk = 4'096;
constexpr int kCallsAtOnce = 16;

struct Address {
  sockaddr_storage storage{};
  socklen_t length = 0;
  int family = 0;
  const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&storage); }
};

// Once, at the start: looking up a name may take its time.
bool resolve(const std::string& host, std::uint16_t port, bool listens, Address& address,
             std::string& reason) {
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_NUMERICSERV | (listens ? AI_PASSIVE : 0);
  addrinfo* found = nullptr;
  const std::string name = host.empty() && listens ? "127.0.0.1" : host;
  const int error = ::getaddrinfo(name.c_str(), std::to_string(port).c_str(), &hints, &found);
  if (error != 0) {
    reason = name + ": " + ::gai_strerror(error);
    return false;
  }
  std::memcpy(&address.storage, found->ai_addr, found->ai_addrlen);
  address.length = found->ai_addrlen;
  address.family = found->ai_family;
  ::freeaddrinfo(found);
  return true;
}

int newSocket(const Address& address) {
  return ::socket(address.family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
}

// Characters go at once.
void hurry(int file) {
  const int on = 1;
  ::setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

class Network : public SerialStream {
 public:
  explicit Network(std::string name) : name_(std::move(name)) {}

  void read(SerialInput& input, std::size_t most) override {
    std::array<std::uint8_t, kNetworkChunk> bytes{};
    if (!connection_.open() || most == 0) return;
    const ssize_t count =
        ::recv(connection_.number(), bytes.data(), std::min(most, bytes.size()), 0);
    if (count == 0 || (count < 0 && !wouldWait())) return connection_.reset();
    for (ssize_t i = 0; i < count; ++i)
      input.characters.push_back({bytes[static_cast<std::size_t>(i)]});
  }
  std::size_t write(const std::vector<std::uint8_t>& bytes) override {
    if (!connection_.open()) return bytes.size();  // nobody hears it
    const ssize_t count = ::send(connection_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count < 0 && !wouldWait()) connection_.reset();
    return count < 0 ? 0 : static_cast<std::size_t>(count);
  }
  std::string name() const override { return name_; }

 protected:
  SerialFile connection_;
  std::string name_;
};

// One connection; who calls while there is one is sent away.
class Listener : public Network {
 public:
  Listener(SerialFile socket, std::string name)
      : Network(std::move(name)), socket_(std::move(socket)) {}

  bool connected() override {
    for (int calls = 0; calls < kCallsAtOnce; ++calls) {
      SerialFile caller(
          ::accept4(socket_.number(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
      if (!caller.open()) break;
      if (connection_.open()) continue;
      hurry(caller.number());
      connection_ = std::move(caller);
    }
    return connection_.open();
  }

 private:
  SerialFile socket_;
};

class Caller : public Network {
 public:
  Caller(const Address& address, std::string name) : Network(std::move(name)), address_(address) {}

  bool connected() override {
    if (connection_.open()) return true;
    if (pending_.open()) return answered();
    const auto now = std::chrono::steady_clock::now();
    if (now < again_) return false;
    again_ = now + std::chrono::seconds(1);
    pending_.reset(newSocket(address_));
    const bool calling =
        pending_.open() && (::connect(pending_.number(), address_.get(), address_.length) == 0 ||
                            errno == EINPROGRESS);
    if (!calling) pending_.reset();
    return false;
  }

 protected:
  virtual void begun() {}

 private:
  bool answered() {
    pollfd file{.fd = pending_.number(), .events = POLLOUT, .revents = 0};
    if (::poll(&file, 1, 0) <= 0) return false;
    int error = 0;
    socklen_t length = sizeof error;
    ::getsockopt(pending_.number(), SOL_SOCKET, SO_ERROR, &error, &length);
    if (error != 0) return pending_.reset(), false;
    hurry(pending_.number());
    connection_ = std::move(pending_);
    begun();
    return true;
  }

  Address address_;
  SerialFile pending_;
  std::chrono::steady_clock::time_point again_;
};

// Characters and commands of telnet in one stream: what is encoded is sent before more is taken.
class ComPortCaller : public Caller {
 public:
  ComPortCaller(const Address& address, std::string name, const serial::Settings& settings)
      : Caller(address, std::move(name)), port_(settings) {}

  void read(SerialInput& input, std::size_t most) override {
    SerialInput raw;
    Caller::read(raw, most);
    for (const SerialInput::Character& one : raw.characters)
      if (!port_.take(one.value, input)) return connection_.reset();
    flush();
  }
  std::size_t write(const std::vector<std::uint8_t>& bytes) override {
    if (!connection_.open()) return bytes.size();
    std::size_t taken = 0;
    for (; taken < bytes.size() && waiting_.size() < kNetworkChunk; ++taken)
      ComPort::encode(bytes[taken], waiting_);
    flush();
    return taken;
  }
  std::string takeNotice() override { return port_.takeNotice(); }

 private:
  void begun() override {
    waiting_.clear();
    port_.start();
    flush();
  }
  void flush() {
    std::vector<std::uint8_t>& commands = port_.commands();
    waiting_.insert(waiting_.end(), commands.begin(), commands.end());
    commands.clear();
    if (waiting_.size() > kNetworkChunk + ComPort::kMostCommands) return connection_.reset();
    const std::size_t sent = waiting_.empty() ? 0 : Caller::write(waiting_);
    waiting_.erase(waiting_.begin(),
                   waiting_.begin() + static_cast<std::ptrdiff_t>(std::min(sent, waiting_.size())));
  }

  ComPort port_;
  std::vector<std::uint8_t> waiting_;
};

std::uint16_t portOf(int file) {
  sockaddr_storage storage{};
  socklen_t length = sizeof storage;
  if (::getsockname(file, reinterpret_cast<sockaddr*>(&storage), &length) != 0) return 0;
  return ntohs(storage.ss_family == AF_INET6 ? reinterpret_cast<sockaddr_in6*>(&storage)->sin6_port
                                             : reinterpret_cast<sockaddr_in*>(&storage)->sin_port);
}

}  // namespace

std::unique_ptr<SerialStream> listenAt(const std::string& host, std::uint16_t port,
                                       std::string& reason) {
  Address address;
  if (!resolve(host, port, true, address, reason)) return nullptr;
  SerialFile socket(newSocket(address));
  const int on = 1;
  const bool good = socket.open() &&
                    ::setsockopt(socket.number(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) == 0 &&
                    ::bind(socket.number(), address.get(), address.length) == 0 &&
                    ::listen(socket.number(), kCallsAtOnce) == 0;
  if (!good) {
    reason = whyNot("port " + std::to_string(port));
    return nullptr;
  }
  const std::string name =
      (host.empty() ? "127.0.0.1" : host) + ":" + std::to_string(portOf(socket.number()));
  return std::make_unique<Listener>(std::move(socket), name);
}

std::unique_ptr<SerialStream> connectTo(const std::string& host, std::uint16_t port,
                                        std::string& reason) {
  Address address;
  if (!resolve(host, port, false, address, reason)) return nullptr;
  return std::make_unique<Caller>(address, host + ":" + std::to_string(port));
}

std::unique_ptr<SerialStream> connectToComPort(const std::string& host, std::uint16_t port,
                                               const serial::Settings& settings,
                                               std::string& reason) {
  Address address;
  if (!resolve(host, port, false, address, reason)) return nullptr;
  return std::make_unique<ComPortCaller>(address, host + ":" + std::to_string(port), settings);
}

}  // namespace merker::app
