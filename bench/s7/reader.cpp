// Reads 64 bytes of DB 1 over S7 communication as fast as a server answers: CONNECTIONS sockets in
// one thread, OUTSTANDING requests on each. Prints reads a second, and how long half of them and 99
// of 100 took (us).
// usage: merker_s7_reader PORT CONNECTIONS OUTSTANDING SECONDS
#include <arpa/inet.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;
using Octets = std::vector<std::uint8_t>;

// TPKT, COTP connection request: TPDU of 1024 octets, TSAP 01 00 calls 01 02.
const Octets kConnect = {3,    0, 0,  22,   0x11, 0xE0, 0, 0,    0, 1, 0,
                         0xC0, 1, 10, 0xC1, 2,    1,    0, 0xC2, 2, 1, 2};
// Setup: eight jobs each way, PDU 480.
const Octets kSetup = {3, 0, 0, 25, 2,    0xF0, 0x80, 0x32, 1, 0, 0, 0,   0,
                       0, 8, 0, 0,  0xF0, 0,    0,    8,    0, 8, 1, 0xE0};
// Read: 64 bytes from DB1.DBB 0 on.
const Octets kRead = {3, 0, 0, 31,   2,    0xF0, 0x80, 0x32, 1,  0, 0, 0,    1, 0, 14, 0,
                      0, 4, 1, 0x12, 0x0A, 0x10, 2,    0,    64, 0, 1, 0x84, 0, 0, 0};
constexpr std::size_t kReadAnswer = 7 + 12 + 2 + 4 + 64;

[[noreturn]] void fail(const char* what) {
  std::perror(what);
  std::exit(1);
}

void sendAll(int socket, const Octets& octets) {
  if (send(socket, octets.data(), octets.size(), MSG_NOSIGNAL) !=
      static_cast<ssize_t>(octets.size()))
    fail("send");
}

void expect(int socket, std::uint8_t tpdu) {
  std::array<std::uint8_t, 256> answer{};
  const ssize_t count = recv(socket, answer.data(), answer.size(), 0);
  if (count < 7 || answer[5] != tpdu) fail("no such answer");
}

int connection(std::uint16_t port) {
  const int one = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (connect(one, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) fail("connect");
  const int yes = 1;
  setsockopt(one, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  sendAll(one, kConnect);
  expect(one, 0xD0);
  sendAll(one, kSetup);
  expect(one, 0xF0);
  return one;
}

struct Line {
  int socket = -1;
  std::size_t pending = 0;  // octets of an answer that has begun
  std::deque<Clock::time_point> asked{};

  void ask() {
    asked.push_back(Clock::now());
    sendAll(socket, kRead);
  }
};

// Answers that came; the requests behind them go out at once.
void take(Line& line, std::vector<float>& took) {
  std::array<std::uint8_t, 16'384> octets{};
  const ssize_t count = recv(line.socket, octets.data(), octets.size(), 0);
  if (count <= 0) fail("the server closed the connection");
  line.pending += static_cast<std::size_t>(count);
  for (; line.pending >= kReadAnswer; line.pending -= kReadAnswer) {
    const std::chrono::duration<float, std::micro> time = Clock::now() - line.asked.front();
    took.push_back(time.count());
    line.asked.pop_front();
    line.ask();
  }
}

std::vector<float> measure(std::vector<Line>& lines, double seconds) {
  std::vector<float> took;
  took.reserve(1'000'000);
  std::vector<pollfd> polled;
  for (const Line& line : lines) polled.push_back({line.socket, POLLIN, 0});
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  while (Clock::now() < end) {
    if (poll(polled.data(), polled.size(), 1000) <= 0) fail("the server does not answer");
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (polled[i].revents != 0) take(lines[i], took);
  }
  return took;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 5) {
    std::fputs("usage: merker_s7_reader PORT CONNECTIONS OUTSTANDING SECONDS\n", stderr);
    return 2;
  }
  const double seconds = std::atof(arguments[4]);
  std::vector<Line> lines(static_cast<std::size_t>(std::atoi(arguments[2])));
  for (Line& line : lines)
    line.socket = connection(static_cast<std::uint16_t>(std::atoi(arguments[1])));
  for (Line& line : lines)
    for (int i = 0; i < std::atoi(arguments[3]); ++i) line.ask();
  std::vector<float> took = measure(lines, seconds);
  std::sort(took.begin(), took.end());
  const auto share = [&](double part) {
    return took.at(static_cast<std::size_t>(part * static_cast<double>(took.size() - 1)));
  };
  std::printf("{\"reads\": %.0f, \"half\": %.1f, \"most\": %.1f}\n",
              static_cast<double>(took.size()) / seconds, share(0.5), share(0.99));
}
