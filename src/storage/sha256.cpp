// A plain implementation of FIPS 180-4 (section numbers below are its own), so that the core needs no cryptographic library.
#include "storage/sha256.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace collision_hulls {
namespace {

constexpr std::size_t kBlock = 64;                    // bytes per compression
constexpr std::size_t kPiece = std::size_t{1} << 22;  // bytes between looks at the cancel flag: about 15 ms

// First 32 bits of the fractional parts of the cube roots of the first 64 primes (section 4.2.2).
constexpr std::array<std::uint32_t, 64> kRound = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5, 0xd807aa98, 0x12835b01, 0x243185be,
    0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174, 0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa,
    0x5cb0a9dc, 0x76f988da, 0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967, 0x27b70a85,
    0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85, 0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3,
    0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070, 0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f,
    0x682e6ff3, 0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

std::uint32_t rotated(std::uint32_t x, int bits) {
  return (x >> bits) | (x << (32 - bits));
}

std::uint32_t bigEndian(const unsigned char* p) {
  return std::uint32_t{p[0]} << 24 | std::uint32_t{p[1]} << 16 | std::uint32_t{p[2]} << 8 | std::uint32_t{p[3]};
}

class Sha256 {
 public:
  void update(const char* data, std::size_t size) {
    length_ += size;
    while (size > 0) {
      const std::size_t taken = std::min(size, kBlock - filled_);
      std::memcpy(block_.data() + filled_, data, taken);
      data += taken;
      size -= taken;
      filled_ += taken;
      if (filled_ == kBlock) compress();
    }
  }

  void update(std::string_view bytes) { update(bytes.data(), bytes.size()); }

  /// Ends the message.
  std::array<std::uint32_t, 8> words() {
    const std::uint64_t bits = length_ * 8;
    update("\x80", 1);
    const char zero = 0;
    while (filled_ != kBlock - 8) update(&zero, 1);
    for (int shift = 56; shift >= 0; shift -= 8) {
      const char byte = static_cast<char>(bits >> shift);
      update(&byte, 1);
    }
    return state_;
  }

 private:
  void compress() {
    std::array<std::uint32_t, 64> w;
    for (std::size_t i = 0; i < 16; ++i) w[i] = bigEndian(block_.data() + 4 * i);
    for (std::size_t i = 16; i < 64; ++i) {
      const std::uint32_t s0 = rotated(w[i - 15], 7) ^ rotated(w[i - 15], 18) ^ (w[i - 15] >> 3);
      const std::uint32_t s1 = rotated(w[i - 2], 17) ^ rotated(w[i - 2], 19) ^ (w[i - 2] >> 10);
      w[i] = w[i - 16] + s0 + w[i - 7] + s1;
    }
    auto [a, b, c, d, e, f, g, h] = state_;
    for (std::size_t i = 0; i < 64; ++i) {
      const std::uint32_t t1 = h + (rotated(e, 6) ^ rotated(e, 11) ^ rotated(e, 25)) + ((e & f) ^ (~e & g)) + kRound[i] + w[i];
      const std::uint32_t t2 = (rotated(a, 2) ^ rotated(a, 13) ^ rotated(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
      h = g, g = f, f = e, e = d + t1, d = c, c = b, b = a, a = t1 + t2;
    }
    const std::array<std::uint32_t, 8> added = {a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < 8; ++i) state_[i] += added[i];
    filled_ = 0;
  }

  // First 32 bits of the fractional parts of the square roots of the first 8 primes (section 5.3.3).
  std::array<std::uint32_t, 8> state_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<unsigned char, kBlock> block_{};
  std::size_t filled_ = 0;
  std::uint64_t length_ = 0;
};

std::string hex(const std::array<std::uint32_t, 8>& words) {
  std::string text;
  for (const std::uint32_t word : words) {
    for (int shift = 28; shift >= 0; shift -= 4) text += "0123456789abcdef"[(word >> shift) & 15];
  }
  return text;
}

/// A hash that has taken the key, with every byte combined with `pad` (RFC 2104, section 2).
Sha256 keyed(std::string_view key, char pad) {
  std::array<char, kBlock> block;
  block.fill(pad);
  for (std::size_t i = 0; i < key.size(); ++i) block[i] = static_cast<char>(key[i] ^ pad);
  Sha256 hash;
  hash.update(block.data(), block.size());
  return hash;
}

}  // namespace

std::string sha256(std::string_view bytes, const RunControl& control) {
  Sha256 hash;
  for (std::size_t done = 0; done < bytes.size(); done += kPiece) {
    control.check();
    hash.update(bytes.substr(done, kPiece));
  }
  return hex(hash.words());
}

std::string hmacSha256(std::string_view key, std::initializer_list<std::string_view> parts) {
  Sha256 inner = keyed(key, 0x36), outer = keyed(key, 0x5c);
  for (const std::string_view part : parts) inner.update(part);
  for (const std::uint32_t word : inner.words()) {
    for (int shift = 24; shift >= 0; shift -= 8) {
      const char byte = static_cast<char>(word >> shift);
      outer.update(&byte, 1);
    }
  }
  return hex(outer.words());
}

}  // namespace collision_hulls
