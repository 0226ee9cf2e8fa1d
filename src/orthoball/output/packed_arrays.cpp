// SPDX-License-Identifier: MIT
//
// Deflate finds repeated bytes, and the bytes of one place are more alike than those of one number:
// the high bytes of row numbers are zero, the exponents of alphas in order hardly change. So an
// array is stored as its planes, first the lowest byte of all numbers, then the next. Numbers that
// are near those before them, such as corners of cells in the order of space, become small by
// differences, whose sign goes to the lowest bit. (Blosc and HDF5 do the same as "shuffle".)

#include "orthoball/output/packed_arrays.h"

#include <bit>
#include <cassert>
#include <sstream>
#include <utility>

namespace orthoball {
namespace {

constexpr std::string_view kMagic = "OBsnap1\n";
constexpr std::size_t kAlignment = 8;

std::size_t padded(std::size_t size) { return (size + kAlignment - 1) / kAlignment * kAlignment; }

std::string_view name_of(PackedType type) {
  constexpr std::string_view kNames[] = {"u32", "f64", "f32"};
  return kNames[static_cast<std::size_t>(type)];
}

// Small numbers for small differences of either sign.
std::uint32_t folded(std::uint32_t difference) {
  return (difference << 1U) ^ (0U - (difference >> 31U));
}

// The numbers at places first, first + stride, ... as differences.
void take_differences(PackedArrays::Numbers& numbers, std::size_t stride) {
  for (std::size_t i = numbers.size(); i-- > 0;) {
    numbers[i] = folded(numbers[i] - (i < stride ? 0U : numbers[i - stride]));
  }
}

template <class Word, class Values>
void write_planes(ByteSink& sink, const Values& values) {
  std::string plane(values.size(), '\0');
  for (std::size_t byte = 0; byte < sizeof(Word); ++byte) {
    for (std::size_t i = 0; i < plane.size(); ++i) {
      plane[i] = static_cast<char>(std::bit_cast<Word>(values[i]) >> (8 * byte) & 0xFFU);
    }
    sink.text(plane);
  }
}

}  // namespace

void PackedArrays::add(std::string name, std::size_t length, std::size_t stride,
                       std::function<Numbers()> numbers) {
  arrays_.push_back({std::move(name), PackedType::u32, length, stride, std::move(numbers)});
}

void PackedArrays::add(std::string name, std::size_t length, PackedType type,
                       std::function<Reals()> reals) {
  arrays_.push_back({std::move(name), type, length, 0, std::move(reals)});
}

std::string PackedArrays::header(std::string_view facts) const {
  std::ostringstream out;
  ByteSink json(out);
  json.text("{");
  json.text(facts);
  json.text(",\"arrays\":[");
  std::size_t offset = 0;
  for (const Array& array : arrays_) {
    json.text(offset == 0 && &array == arrays_.data() ? "{\"name\":" : ",{\"name\":");
    json.json_string(array.name);
    json.text(",\"type\":");
    json.json_string(name_of(array.type));
    for (const auto& [key, number] :
         {std::pair(",\"length\":", array.length), std::pair(",\"stride\":", array.stride),
          std::pair(",\"offset\":", offset)}) {
      json.text(key);
      json.integer(static_cast<std::int64_t>(number));
    }
    json.text("}");
    offset = padded(offset + array.size());
  }
  json.text("]}");
  json.flush();
  std::string text = out.str();
  text.resize(padded(text.size()), ' ');
  return text;
}

void PackedArrays::write(ByteSink& sink, std::string_view facts) const {
  const std::string head = header(facts);
  sink.text(kMagic);
  sink.little_endian(std::uint64_t{head.size()});
  sink.text(head);
  for (const Array& array : arrays_) {
    if (const auto* const make = std::get_if<std::function<Numbers()>>(&array.made_by)) {
      Numbers numbers = (*make)();
      assert(numbers.size() == array.length);
      if (array.stride > 0) take_differences(numbers, array.stride);
      write_planes<std::uint32_t>(sink, numbers);
    } else {
      const Reals reals = std::get<std::function<Reals()>>(array.made_by)();
      assert(reals.size() == array.length);
      if (array.type == PackedType::f64) {
        write_planes<std::uint64_t>(sink, reals);
      } else {
        RawVector<float> rounded;
        for (const double real : reals) rounded.push_back(static_cast<float>(real));
        write_planes<std::uint32_t>(sink, rounded);
      }
    }
    sink.text(std::string(padded(array.size()) - array.size(), '\0'));
  }
  sink.flush();
}

}  // namespace orthoball
