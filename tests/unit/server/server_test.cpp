// The server behind a real socket: pages, ports that are taken, TLS, connections that say nothing.
#include "server/server.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <openssl/pem.h>
#include <openssl/ssl.h>
#include <openssl/x509.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

namespace merker::hmi {
namespace {

namespace fs = std::filesystem;

struct Nobody : Handler {
  void opened(BrowserId) override {}
  bool received(BrowserId, std::string) override { return true; }
  void closed(BrowserId) override {}
};

const Asset kPage[] = {{"/index.html", "text/html", "t1", "<p>"},
                       {"/a.js", "text/javascript", "t2", "whole", "small"}};

Options local() {
  Options options;
  options.port = 0;
  options.assets = kPage;
  return options;
}

std::uint16_t portOf(const Server& server) {
  const std::string url = server.url();
  return static_cast<std::uint16_t>(std::stoul(url.substr(url.rfind(':') + 1)));
}

class Socket {
 public:
  explicit Socket(std::uint16_t port) : handle_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(port);
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const timeval patience{60, 0};
    setsockopt(handle_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    EXPECT_EQ(connect(handle_, reinterpret_cast<const sockaddr*>(&to), sizeof to), 0);
  }
  ~Socket() { close(handle_); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  int handle() const { return handle_; }
  void send(const std::string& text) const {
    EXPECT_EQ(::send(handle_, text.data(), text.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(text.size()));
  }
  // Everything up to the end of the connection; `ended` says that there was one.
  std::string rest(bool& ended) const {
    std::string all;
    char part[1024];
    ssize_t count = 0;
    while ((count = recv(handle_, part, sizeof part, 0)) > 0)
      all.append(part, static_cast<std::size_t>(count));
    ended = count == 0 || errno == ECONNRESET;
    return all;
  }

 private:
  int handle_;
};

const std::string kAsk = "GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n";

TEST(Server, GivesThePage) {
  Nobody nobody;
  std::string reason;
  const auto server = Server::start(local(), nobody, reason);
  ASSERT_TRUE(server) << reason;
  EXPECT_TRUE(server->url().starts_with("http://127.0.0.1:"));
  const Socket socket(portOf(*server));
  socket.send(kAsk);
  bool ended = false;
  const std::string answer = socket.rest(ended);
  EXPECT_TRUE(ended);
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 200")) << answer;
  EXPECT_TRUE(answer.ends_with("\r\n\r\n<p>")) << answer;
}

// Packed for who takes that, whole for the others, each known by a tag of its own.
TEST(Server, GivesFilesPacked) {
  Nobody nobody;
  std::string reason;
  const auto server = Server::start(local(), nobody, reason);
  ASSERT_TRUE(server) << reason;
  const auto ask = [&](const std::string& field) {
    const Socket socket(portOf(*server));
    socket.send("GET /a.js HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n" + field + "\r\n");
    bool ended = false;
    return socket.rest(ended);
  };
  for (const char* const takes : {"gzip", "deflate, gzip", "br;q=1, gzip; q=0.5"}) {
    const std::string answer = ask(std::string("Accept-Encoding: ") + takes + "\r\n");
    EXPECT_TRUE(answer.ends_with("\r\n\r\nsmall")) << takes << '\n' << answer;
    EXPECT_NE(answer.find("Content-Encoding: gzip\r\n"), std::string::npos) << answer;
    EXPECT_NE(answer.find("Content-Length: 5\r\n"), std::string::npos) << answer;
    EXPECT_NE(answer.find("Vary: Accept-Encoding\r\n"), std::string::npos) << answer;
  }
  for (const char* const refuses : {"", "Accept-Encoding: br\r\n", "Accept-Encoding: gzip;q=0\r\n",
                                    "Accept-Encoding: xgzip\r\n"}) {
    const std::string answer = ask(refuses);
    EXPECT_TRUE(answer.ends_with("\r\n\r\nwhole")) << refuses << '\n' << answer;
    EXPECT_EQ(answer.find("Content-Encoding"), std::string::npos) << answer;
  }
  const std::string known = ask("Accept-Encoding: gzip\r\nIf-None-Match: \"t2-gzip\"\r\n");
  EXPECT_TRUE(known.starts_with("HTTP/1.1 304")) << known;
  EXPECT_TRUE(ask("If-None-Match: \"t2-gzip\"\r\n").starts_with("HTTP/1.1 200"));
}

TEST(Server, SaysThatThePortIsTaken) {
  Nobody nobody;
  std::string reason;
  const auto first = Server::start(local(), nobody, reason);
  ASSERT_TRUE(first) << reason;
  Options same = local();
  same.port = portOf(*first);
  EXPECT_FALSE(Server::start(same, nobody, reason));
  EXPECT_NE(reason.find("is in use by another program"), std::string::npos) << reason;
}

// Key and self-signed certificate, in a folder of their own.
class Tls : public ::testing::Test {
 protected:
  Tls() {
    std::string pattern = (fs::temp_directory_path() / "merker-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    options_ = local();
    options_.certificate = (folder_ / "c.pem").string();
    options_.key = (folder_ / "k.pem").string();
    EVP_PKEY* key = EVP_RSA_gen(2048);
    X509* certificate = X509_new();
    X509_gmtime_adj(X509_getm_notBefore(certificate), 0);
    X509_gmtime_adj(X509_getm_notAfter(certificate), 86'400);
    X509_set_pubkey(certificate, key);
    X509_sign(certificate, key, EVP_sha256());
    write(options_.key, [&](BIO* out) {
      PEM_write_bio_PrivateKey(out, key, nullptr, nullptr, 0, nullptr, nullptr);
    });
    write(options_.certificate, [&](BIO* out) { PEM_write_bio_X509(out, certificate); });
    X509_free(certificate);
    EVP_PKEY_free(key);
  }
  ~Tls() override { fs::remove_all(folder_); }
  template <typename Writer>
  static void write(const std::string& file, Writer writer) {
    BIO* out = BIO_new_file(file.c_str(), "w");
    writer(out);
    BIO_free(out);
  }
  fs::path folder_;
  Options options_;
  Nobody nobody_;
  std::string reason_;
};

std::string askByTls(int handle) {
  SSL_CTX* context = SSL_CTX_new(TLS_client_method());
  SSL* session = SSL_new(context);
  SSL_set_fd(session, handle);
  std::string all;
  char part[1024];
  int count = 0;
  if (SSL_connect(session) == 1 && SSL_write(session, kAsk.data(), int(kAsk.size())) > 0)
    while ((count = SSL_read(session, part, sizeof part)) > 0)
      all.append(part, static_cast<std::size_t>(count));
  SSL_free(session);
  SSL_CTX_free(context);
  return all;
}

TEST_F(Tls, GivesThePage) {
  const auto server = Server::start(options_, nobody_, reason_);
  ASSERT_TRUE(server) << reason_;
  EXPECT_TRUE(server->url().starts_with("https://127.0.0.1:"));
  const Socket socket(portOf(*server));
  EXPECT_TRUE(askByTls(socket.handle()).ends_with("\r\n\r\n<p>"));
}

// Who connects and says nothing is not waited for: neither for a greeting of TLS nor for a request.
TEST_F(Tls, ASilentConnectionIsClosed) {
  for (const bool secure : {true, false}) {
    Options options = secure ? options_ : local();
    options.limits.request = 1;
    const auto server = Server::start(options, nobody_, reason_);
    ASSERT_TRUE(server) << reason_;
    const Socket socket(portOf(*server));
    bool ended = false;
    EXPECT_EQ(socket.rest(ended), "");
    EXPECT_TRUE(ended) << (secure ? "TLS" : "plain");
  }
}

TEST_F(Tls, SaysWhatIsWrong) {
  Options wrong = options_;
  std::swap(wrong.certificate, wrong.key);
  EXPECT_FALSE(Server::start(wrong, nobody_, reason_));
  EXPECT_NE(reason_.find("cannot be used"), std::string::npos) << reason_;
  wrong = options_;
  wrong.token = "0123456789abcdef";
  wrong.address = "nowhere";
  EXPECT_FALSE(Server::start(wrong, nobody_, reason_));
  EXPECT_NE(reason_.find("'nowhere' is not a valid address"), std::string::npos) << reason_;
}

}  // namespace
}  // namespace merker::hmi
