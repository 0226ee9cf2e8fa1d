// SPDX-License-Identifier: MIT
#include "orthoball/output/encoded_output.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <new>
#include <streambuf>
#include <string_view>
#include <utility>

namespace orthoball {

class GzipOutput::Buffer : public std::streambuf {
 public:
  explicit Buffer(ByteSink& to) : to_(to) {
    // Planes of bytes, such as snapshots are made of, gain little from longer searches.
    constexpr int kLevel = 5, kGzip = 16, kWindow = 15, kMemory = 9;
    if (deflateInit2(&state_, kLevel, Z_DEFLATED, kWindow + kGzip, kMemory, Z_DEFAULT_STRATEGY) !=
        Z_OK) {
      throw std::bad_alloc();
    }
  }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;
  ~Buffer() override { deflateEnd(&state_); }

  void finish() { compress({}, Z_FINISH); }

 protected:
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    // zlib counts the input in 32 bits.
    constexpr std::size_t kMost = std::size_t{1} << 30U;
    std::string_view rest(text, static_cast<std::size_t>(size));
    for (; !rest.empty(); rest.remove_prefix(std::min(kMost, rest.size()))) {
      compress(rest.substr(0, kMost), Z_NO_FLUSH);
    }
    return size;
  }
  int_type overflow(int_type c) override {
    if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
    const char byte = traits_type::to_char_type(c);
    compress({&byte, 1}, Z_NO_FLUSH);
    return c;
  }

 private:
  void compress(std::string_view bytes, int flush) {
    // zlib does not write to its input, which it takes as not const.
    state_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    state_.avail_in = static_cast<uInt>(bytes.size());
    do {
      state_.next_out = reinterpret_cast<Bytef*>(piece_.data());
      state_.avail_out = static_cast<uInt>(piece_.size());
      deflate(&state_, flush);
      to_.text({piece_.data(), piece_.size() - state_.avail_out});
    } while (state_.avail_out == 0);
  }

  ByteSink& to_;
  z_stream state_{};
  std::array<char, std::size_t{1} << 16U> piece_;
};

GzipOutput::GzipOutput(ByteSink& to)
    : std::ostream(nullptr), buffer_(std::make_unique<Buffer>(to)) {
  rdbuf(buffer_.get());
  exceptions(badbit);  // what the sink throws goes through
}
GzipOutput::~GzipOutput() = default;
void GzipOutput::finish() { buffer_->finish(); }

class Base64Output::Buffer : public std::streambuf {
 public:
  Buffer(ByteSink& to, std::string between, std::size_t length)
      : to_(to), between_(std::move(between)), length_(length) {}

  void finish() {
    if (count_ == 0) return;
    const std::size_t missing = 3 - count_;
    for (std::size_t i = 0; i < missing; ++i) put(0);
    text_.resize(text_.size() - missing);
    text_.append(missing, '=');
    hand_over();
  }

 protected:
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    for (std::streamsize i = 0; i < size; ++i) put(static_cast<unsigned char>(text[i]));
    hand_over();
    return size;
  }
  int_type overflow(int_type c) override {
    if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
    put(static_cast<unsigned char>(traits_type::to_char_type(c)));
    hand_over();
    return c;
  }

 private:
  void put(std::uint32_t byte) {
    bits_ = bits_ << 8U | byte;
    if (++count_ < 3) return;
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (const unsigned shift : {18U, 12U, 6U, 0U}) text_ += kDigits[bits_ >> shift & 63U];
    bits_ = 0;
    count_ = 0;
  }
  void hand_over() {
    if (text_.empty()) return;
    if (written_ >= length_) {
      to_.text(between_);
      written_ = 0;
    }
    to_.text(text_);
    written_ += text_.size();
    text_.clear();
  }

  ByteSink& to_;
  std::string between_;
  std::size_t length_, written_ = 0;  // of the part
  std::uint32_t bits_ = 0;            // of `count_` bytes
  std::size_t count_ = 0;
  std::string text_;
};

Base64Output::Base64Output(ByteSink& to)
    : Base64Output(to, {}, std::numeric_limits<std::size_t>::max()) {}
Base64Output::Base64Output(ByteSink& to, std::string between, std::size_t length)
    : std::ostream(nullptr), buffer_(std::make_unique<Buffer>(to, std::move(between), length)) {
  rdbuf(buffer_.get());
  exceptions(badbit);
}
Base64Output::~Base64Output() = default;
void Base64Output::finish() { buffer_->finish(); }

}  // namespace orthoball
