#include "server/tls.h"

namespace merker::hmi {

namespace ssl = boost::asio::ssl;

std::unique_ptr<ssl::context> makeTls(const std::string& certificate, const std::string& key,
                                      std::string& reason) {
  auto context = std::make_unique<ssl::context>(ssl::context::tls_server);
  boost::system::error_code error;
  context->set_options(ssl::context::default_workarounds | ssl::context::no_tlsv1 |
                           ssl::context::no_tlsv1_1 | ssl::context::single_dh_use,
                       error);
  if (!error && context->use_certificate_chain_file(certificate, error)) {
    reason = "the certificate " + certificate + " cannot be used: " + error.message();
    return nullptr;
  }
  if (!error && context->use_private_key_file(key, ssl::context::pem, error)) {
    reason = "the key " + key + " cannot be used: " + error.message();
    return nullptr;
  }
  if (error) reason = error.message();
  return error ? nullptr : std::move(context);
}

}  // namespace merker::hmi
