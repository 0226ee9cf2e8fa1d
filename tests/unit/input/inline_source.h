// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "orthoball/error.h"
#include "orthoball/input/formats.h"

namespace orthoball {

using ReaderFunction = Reading (*)(const Source&, const ReadOptions&);

inline Reading reading_of(ReaderFunction reader, const std::string& bytes,
                          const ReadOptions& options = {}) {
  return reader(Source{"f", bytes}, options);
}

// What the reader says against the bytes; empty if it accepts them.
inline std::string error_of(ReaderFunction reader, const std::string& bytes,
                            const ReadOptions& options = {}) {
  try {
    static_cast<void>(reading_of(reader, bytes, options));
  } catch (const ParseError& error) {
    return error.what();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

// [dimension * row + axis], in input units.
inline std::vector<double> coordinates_of(const Reading& reading) {
  std::vector<double> coordinates;
  for (std::size_t row = 0; row < reading.points.size(); ++row) {
    for (int axis = 0; axis < reading.points.dimension(); ++axis) {
      coordinates.push_back(reading.points.coordinate(row, axis));
    }
  }
  return coordinates;
}

// The `size` lowest bytes of a number, little-endian.
inline std::string little_endian(unsigned long long number, std::size_t size) {
  std::string bytes;
  for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(number >> (8 * i) & 255U);
  return bytes;
}

}  // namespace orthoball
