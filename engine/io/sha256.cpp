#include "engine/io/sha256.hpp"

#include <openssl/evp.h>

#include <memory>

#include "engine/core/contract.hpp"
#include "engine/core/file.hpp"

namespace windloom {
namespace {

class Sha256 {
 public:
  Sha256() : m_context(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
    WL_REQUIRE(m_context != nullptr && EVP_DigestInit_ex(m_context.get(), EVP_sha256(), nullptr) == 1,
               "libcrypto has SHA-256");
  }
  void add(std::string_view bytes) { EVP_DigestUpdate(m_context.get(), bytes.data(), bytes.size()); }
  std::string finish() {
    unsigned char digest[EVP_MAX_MD_SIZE];
    unsigned length = 0;
    EVP_DigestFinal_ex(m_context.get(), digest, &length);
    std::string text;
    for (unsigned i = 0; i < length; ++i) {
      text += "0123456789abcdef"[digest[i] >> 4];
      text += "0123456789abcdef"[digest[i] & 0xf];
    }
    return text;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> m_context;
};

}  // namespace

std::string sha256(std::string_view bytes) {
  Sha256 hash;
  hash.add(bytes);
  return hash.finish();
}

Result<std::string> sha256OfFile(const std::filesystem::path& path) {
  Sha256 hash;
  if (Status read = readFileInPieces(path, [&](std::string_view piece) { hash.add(piece); }); !read)
    return makeError(ErrorKind::Machine, path.string(), {}, read.error().problems.front().message);
  return hash.finish();
}

}  // namespace windloom
