#include "serial_device.h"

#include <fcntl.h>
#include <linux/serial.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

#include "serial_file.h"

namespace merker::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kChunk = 4'096;

// A terminal that passes every character on.
class Terminal : public SerialStream {
 public:
  Terminal(SerialFile file, std::string name) : file_(std::move(file)), name_(std::move(name)) {}

  std::size_t write(const std::vector<std::uint8_t>& bytes) override {
    const ssize_t count = ::write(file_.number(), bytes.data(), bytes.size());
    return count < 0 ? 0 : static_cast<std::size_t>(count);
  }
  std::string name() const override { return name_; }

 protected:
  std::size_t take(std::array<std::uint8_t, kChunk>& bytes, std::size_t most) {
    const ssize_t count = ::read(file_.number(), bytes.data(), std::min(most, bytes.size()));
    return count < 0 ? 0 : static_cast<std::size_t>(count);
  }

  SerialFile file_;
  std::string name_;
};

class Pty : public Terminal {
 public:
  Pty(SerialFile file, std::string name, std::string link)
      : Terminal(std::move(file), std::move(name)), link_(std::move(link)) {}
  ~Pty() override {
    std::error_code error;
    if (fs::is_symlink(link_, error) && fs::read_symlink(link_, error) == name_)
      fs::remove(link_, error);
  }

  void read(SerialInput& input, std::size_t most) override {
    std::array<std::uint8_t, kChunk> bytes{};
    const std::size_t count = take(bytes, most);
    for (std::size_t i = 0; i < count; ++i) input.characters.push_back({bytes[i]});
  }
  // Nobody has the other side open: the line is open (PTP-LINE-05).
  bool connected() override {
    pollfd file{.fd = file_.number(), .events = POLLIN, .revents = 0};
    return ::poll(&file, 1, 0) >= 0 && (file.revents & POLLHUP) == 0;
  }

 private:
  std::string link_;
};

speed_t speedOf(std::uint32_t baud) {
  switch (baud) {
    case 300:
      return B300;
    case 600:
      return B600;
    case 1200:
      return B1200;
    case 2400:
      return B2400;
    case 4800:
      return B4800;
    case 19200:
      return B19200;
    case 38400:
      return B38400;
    default:
      return B9600;
  }
}

// Faulty characters and BREAK are marked: FF 00 X, FF 00 00; FF is doubled.
termios settingsOf(const serial::Settings& settings) {
  termios t{};
  ::cfmakeraw(&t);
  t.c_iflag |= INPCK | PARMRK;
  t.c_cflag |= CREAD | CLOCAL;
  t.c_cflag =
      (t.c_cflag & ~static_cast<tcflag_t>(CSIZE)) | (settings.frame.dataBits == 7 ? CS7 : CS8);
  if (settings.frame.parity != serial::Parity::None) t.c_cflag |= PARENB;
  if (settings.frame.parity == serial::Parity::Odd) t.c_cflag |= PARODD;
  if (settings.frame.stopBits == 2) t.c_cflag |= CSTOPB;
  ::cfsetispeed(&t, speedOf(settings.baud));
  ::cfsetospeed(&t, speedOf(settings.baud));
  return t;
}

class Device : public Terminal {
 public:
  using Terminal::Terminal;

  void read(SerialInput& input, std::size_t most) override {
    std::array<std::uint8_t, kChunk> bytes{};
    const std::size_t count = take(bytes, most);
    for (std::size_t i = 0; i < count; ++i) unmark(bytes[i], input);
  }
  bool connected() override { return file_.open(); }

 private:
  enum class Mark : std::uint8_t { None, Begun, Fault };
  void unmark(std::uint8_t byte, SerialInput& input) {
    constexpr std::uint8_t kMark = 0xFF;
    const Mark before = std::exchange(mark_, Mark::None);
    if (before == Mark::Fault) {
      if (byte == 0)
        input.interrupted = true;
      else
        input.characters.push_back({byte, true});
    } else if (before == Mark::Begun && byte == 0) {
      mark_ = Mark::Fault;
    } else if (before == Mark::None && byte == kMark) {
      mark_ = Mark::Begun;
    } else {
      input.characters.push_back({byte});
    }
  }

  Mark mark_ = Mark::None;
};

// Half duplex: the driver switches the direction where it can.
void switchDirection(int file) {
  serial_rs485 rs485{};
  rs485.flags = SER_RS485_ENABLED | SER_RS485_RTS_ON_SEND;
  static_cast<void>(::ioctl(file, TIOCSRS485, &rs485));
}

// The other side passes every character on, too, whoever opens it.
bool makeRaw(const std::string& path) {
  const SerialFile side(::open(path.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
  termios t{};
  if (!side.open() || ::tcgetattr(side.number(), &t) != 0) return false;
  ::cfmakeraw(&t);
  return ::tcsetattr(side.number(), TCSANOW, &t) == 0;
}

// An old link to a pseudo terminal goes; anything else stays.
bool link(const std::string& path, const std::string& target, std::string& reason) {
  std::error_code error;
  const bool old = fs::is_symlink(path, error) &&
                   fs::read_symlink(path, error).string().starts_with("/dev/pts/");
  if (old) fs::remove(path, error);
  error.clear();
  fs::create_symlink(target, path, error);
  if (error) reason = path + ": " + error.message();
  return !error;
}

}  // namespace

std::unique_ptr<SerialStream> openPty(const std::string& path, std::string& reason) {
  SerialFile file(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  std::array<char, 128> name{};
  if (!file.open() || ::grantpt(file.number()) != 0 || ::unlockpt(file.number()) != 0 ||
      ::ptsname_r(file.number(), name.data(), name.size()) != 0 || !makeRaw(name.data())) {
    reason = whyNot("pseudo terminal");
    return nullptr;
  }
  if (!link(path, name.data(), reason)) return nullptr;
  return std::make_unique<Pty>(std::move(file), name.data(), path);
}

std::unique_ptr<SerialStream> openDevice(const std::string& path, const serial::Settings& settings,
                                         std::string& reason) {
  SerialFile file(::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  const termios wanted = settingsOf(settings);
  if (!file.open() || ::tcsetattr(file.number(), TCSANOW, &wanted) != 0) {
    reason = whyNot(path);
    return nullptr;
  }
  if (settings.mode == serial::Mode::TwoWire) switchDirection(file.number());
  return std::make_unique<Device>(std::move(file), path);
}

}  // namespace merker::app
