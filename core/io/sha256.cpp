// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/sha256.h"

#include <openssl/crypto.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>

#include "core/support/error.h"

namespace gonio::io {

namespace {
constexpr std::size_t pieceBytes = std::size_t(1) << 18;

void require(int result) {
  if (result != 1) throw Error("the system's cryptography library cannot compute SHA-256");
}

/// When a process ends, OpenSSL frees what it keeps for each thread, also for one that is just ending and frees it
/// itself: memory would be freed twice. It is left to the system instead.
void startOpenSsl() {
  static const int started = OPENSSL_init_crypto(OPENSSL_INIT_NO_ATEXIT, nullptr);
  require(started);
}
}  // namespace

struct Sha256::Context {
  EVP_MD_CTX* digest = EVP_MD_CTX_new();
  Context() = default;
  ~Context() { EVP_MD_CTX_free(digest); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
};

Sha256::Sha256() {
  startOpenSsl();
  context_ = std::make_unique<Context>();
  require(context_->digest ? EVP_DigestInit_ex(context_->digest, EVP_sha256(), nullptr) : 0);
}

Sha256::~Sha256() = default;

void Sha256::add(std::span<const std::byte> bytes) {
  require(EVP_DigestUpdate(context_->digest, bytes.data(), bytes.size()));
}

std::string Sha256::finish() {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  require(EVP_DigestFinal_ex(context_->digest, digest.data(), &length));
  constexpr char digits[] = "0123456789abcdef";
  std::string hex;
  for (unsigned int i = 0; i < length; ++i) {
    hex += digits[digest[i] >> 4];
    hex += digits[digest[i] & 15];
  }
  return hex;
}

std::string sha256Hex(std::span<const std::byte> bytes) {
  Sha256 hash;
  hash.add(bytes);
  return hash.finish();
}

std::string sha256Hex(std::string_view text) { return sha256Hex(std::as_bytes(std::span(text))); }

std::string sha256Hex(const ByteSource& source, const std::stop_token& stop) {
  Sha256 hash;
  std::vector<std::byte> piece(std::min<std::uint64_t>(source.size(), pieceBytes));
  for (std::uint64_t offset = 0; offset < source.size(); offset += piece.size()) {
    if (stop.stop_requested()) throw Cancelled();
    piece.resize(std::min<std::uint64_t>(source.size() - offset, pieceBytes));
    source.readAt(offset, piece);
    hash.add(piece);
  }
  return hash.finish();
}

}  // namespace gonio::io
