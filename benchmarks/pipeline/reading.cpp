// SPDX-License-Identifier: MIT
// Megabytes a second of the readers: `pipeline_reading FORMAT COUNT [FILE]` writes COUNT points as
// a file, reads it five times and prints the best as one line of JSON. With FILE that file is kept,
// and read as it is if it is there already.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>

#include "benchmarks/case.h"
#include "generators/random.h"
#include "orthoball/input/read.h"

namespace {

using namespace orthoball;

// Points as text or bytes, appended one by one.
struct Writer {
  std::string ending;
  std::function<std::string(std::size_t count)> head;
  std::function<void(std::string& text, std::size_t row, const double* x)> add;
  std::string input_format = {};
};

std::string ply_head(const char* encoding, std::size_t count) {
  return fmt::format(
      "ply\nformat {} 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nend_header\n",
      encoding, count);
}

template <class T>
void append_bytes(std::string& text, T number, bool is_big_endian) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &number, sizeof(T));
  if (is_big_endian) std::reverse(bytes, bytes + sizeof(T));
  text.append(bytes, sizeof(T));
}

std::string npy_head(std::size_t count, const char* type) {
  std::string text =
      fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}, 3), }}", type, count);
  text.resize(117, ' ');
  return std::string("\x93NUMPY\x01\x00\x76\x00", 10) + text + '\n';
}

std::map<std::string, Writer> writers() {
  const auto none = [](std::size_t) { return std::string(); };
  const auto decimals = [](const char* format) {
    return [format](std::string& text, std::size_t, const double* x) {
      fmt::format_to(std::back_inserter(text), fmt::runtime(format), x[0], x[1], x[2]);
    };
  };
  const auto doubles = [](bool is_big_endian) {
    return [is_big_endian](std::string& text, std::size_t, const double* x) {
      for (int axis = 0; axis < 3; ++axis) append_bytes(text, x[axis], is_big_endian);
    };
  };
  std::map<std::string, Writer> all;
  all["csv"] = {"csv", [](std::size_t) { return std::string("x,y,z\n"); },
                decimals("{:.6f},{:.6f},{:.6f}\n")};
  all["csv17"] = {"csv", none, decimals("{},{},{}\n")};
  all["tsv"] = {"tsv", none, decimals("{:.6f}\t{:.6f}\t{:.6f}\n")};
  all["blanks"] = {"txt", none, decimals("{:12.4f} {:12.4f} {:12.4f}\n")};
  all["xyz"] = {"xyz", [](std::size_t n) { return fmt::format("{}\ncomment\n", n); },
                decimals("C {:.6f} {:.6f} {:.6f}\n")};
  all["xyzr"] = {"xyzr", none, decimals("{:.3f} {:.3f} {:.3f} 1.70\n")};
  all["off"] = {"off", [](std::size_t n) { return fmt::format("OFF\n{} 0 0\n", n); },
                decimals("{:.6f} {:.6f} {:.6f}\n")};
  all["obj"] = {"obj", none, decimals("v {:.6f} {:.6f} {:.6f}\n")};
  all["ply"] = {"ply", [](std::size_t n) { return ply_head("ascii", n); },
                decimals("{:.6f} {:.6f} {:.6f}\n")};
  all["ply_little"] = {"ply", [](std::size_t n) { return ply_head("binary_little_endian", n); },
                       doubles(false)};
  all["ply_big"] = {"ply", [](std::size_t n) { return ply_head("binary_big_endian", n); },
                    doubles(true)};
  all["npy"] = {"npy", [](std::size_t n) { return npy_head(n, "<f8"); }, doubles(false)};
  all["npy_float"] = {"npy", [](std::size_t n) { return npy_head(n, "<f4"); },
                      [](std::string& text, std::size_t, const double* x) {
                        for (int axis = 0; axis < 3; ++axis) {
                          append_bytes(text, static_cast<float>(x[axis]), false);
                        }
                      }};
  all["pdb"] = {"pdb", none, [](std::string& text, std::size_t row, const double* x) {
                  fmt::format_to(std::back_inserter(text),
                                 "ATOM  {:5}  CA  ALA A{:4}    {:8.3f}{:8.3f}{:8.3f}  1.00 20.00"
                                 "           C  \n",
                                 row % 100000, row / 5 % 10000, x[0], x[1], x[2]);
                }};
  all["cif"] = {"cif",
                [](std::size_t) {
                  return std::string(
                      "data_x\nloop_\n_atom_site.group_PDB\n_atom_site.id\n"
                      "_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_alt_id\n"
                      "_atom_site.label_comp_id\n_atom_site.label_asym_id\n"
                      "_atom_site.label_seq_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
                      "_atom_site.Cartn_z\n_atom_site.occupancy\n_atom_site.B_iso_or_equiv\n");
                },
                [](std::string& text, std::size_t row, const double* x) {
                  fmt::format_to(std::back_inserter(text),
                                 "ATOM {} C CA . ALA A {} {:.3f} {:.3f} {:.3f} 1.00 20.00\n", row,
                                 row / 5, x[0], x[1], x[2]);
                }};
  return all;
}

void write_file(const Writer& writer, std::size_t count, const std::string& path) {
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) throw std::runtime_error("cannot write " + path);
  generators::Random random(1);
  std::string text = writer.head(count);
  for (std::size_t row = 0; row < count; ++row) {
    double x[3];
    for (double& coordinate : x) coordinate = 1000.0 * random.uniform();
    writer.add(text, row, x);
    if (text.size() < 1U << 20U && row + 1 < count) continue;
    std::fwrite(text.data(), 1, text.size(), file);
    text.clear();
  }
  std::fclose(file);
}

}  // namespace

int main(int argc, char** argv) {
  const auto all = writers();
  if (argc < 3 || all.count(argv[1]) == 0) {
    std::cerr << "usage: FORMAT COUNT [FILE]; FORMAT is one of";
    for (const auto& [name, writer] : all) std::cerr << ' ' << name;
    std::cerr << '\n';
    return 2;
  }
  const Writer& writer = all.at(argv[1]);
  const auto count = static_cast<std::size_t>(std::atoll(argv[2]));
  const std::string path =
      argc > 3 ? argv[3]
               : (std::filesystem::temp_directory_path() /
                  ("orthoball_reading_" + std::string(argv[1]) + "." + writer.ending))
                     .string();
  if (argc <= 3 || !std::filesystem::exists(path)) write_file(writer, count, path);

  const double before = benchmarks::status_megabytes("VmHWM");
  double best = 1e300;
  for (int run = 0; run < 5; ++run) {
    const benchmarks::Stopwatch watch;
    const Reading reading = read(path, {.limited = false});
    best = std::min(best, watch.seconds());
    if (reading.points.size() != count) throw std::logic_error("points were lost");
  }
  const double megabytes = static_cast<double>(std::filesystem::file_size(path)) / 1e6;
  fmt::print(
      "{{\"format\": \"{}\", \"megabytes\": {:.1f}, \"seconds\": {:.3f}, \"megabytes_a_second\": "
      "{:.0f}, \"peak_mb\": {:.0f}, \"peak_before_mb\": {:.0f}}}\n",
      argv[1], megabytes, best, megabytes / best, benchmarks::status_megabytes("VmHWM"), before);
  if (argc <= 3) std::filesystem::remove(path);
}
