// SPDX-License-Identifier: MIT
#include "oracles/closed_manifold.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>
#include <stdexcept>

namespace orthoball::oracles {
namespace {

using Place = std::array<double, 3>;
using Facet = std::vector<std::uint32_t>;

struct Mesh {
  std::vector<Place> places;
  std::vector<Facet> facets;
};

class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}
  template <class T>
  T next() {
    T value;
    if (bytes_.size() < sizeof value) throw std::runtime_error("the PLY ends too soon");
    std::memcpy(&value, bytes_.data(), sizeof value);
    bytes_.remove_prefix(sizeof value);
    return value;
  }
  [[nodiscard]] bool empty() const { return bytes_.empty(); }

 private:
  std::string_view bytes_;
};

std::size_t count_of(std::string_view header, const std::string& element) {
  const std::size_t at = header.find("element " + element + " ");
  if (at == std::string_view::npos) return 0;
  return std::stoull(std::string(header.substr(at + element.size() + 9, 12)));
}

Mesh read(std::string_view ply) {
  constexpr std::string_view kEnd = "end_header\n";
  const std::size_t end = ply.find(kEnd) + kEnd.size();
  const std::string_view header = ply.substr(0, end);
  Bytes data(ply.substr(end));
  Mesh mesh;
  for (std::size_t v = count_of(header, "vertex"); v > 0; --v) {
    Place place;
    for (double& x : place) x = data.next<double>();
    (void)data.next<std::uint32_t>();  // the row
    mesh.places.push_back(place);
  }
  for (std::size_t t = count_of(header, "face"); t > 0; --t) {
    Facet facet(data.next<std::uint8_t>());
    for (std::uint32_t& v : facet) v = data.next<std::uint32_t>();
    mesh.facets.push_back(facet);
  }
  for (std::size_t e = count_of(header, "edge"); e > 0; --e) {
    Facet facet(2);
    for (std::uint32_t& v : facet) v = data.next<std::uint32_t>();
    mesh.facets.push_back(facet);
  }
  if (!data.empty()) throw std::runtime_error("the PLY has more than its header says");
  return mesh;
}

// Whether `next` is one ring.
bool is_one_ring(const std::map<std::uint32_t, std::uint32_t>& next) {
  std::uint32_t at = next.begin()->first;
  for (std::size_t steps = 1; steps <= next.size(); ++steps) {
    const auto found = next.find(at);
    if (found == next.end()) return false;
    at = found->second;
    if (at == next.begin()->first) return steps == next.size();
  }
  return false;
}

void check_sides(const Mesh& mesh, std::vector<std::string>& faults) {
  std::set<std::array<std::uint32_t, 2>> sides;
  for (const Facet& facet : mesh.facets) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!sides.insert({facet[i], facet[(i + 1) % 3]}).second) {
        faults.push_back("a side is there twice in one direction");
      }
    }
  }
  for (const auto& [from, to] : sides) {
    if (sides.count({to, from}) == 0) faults.push_back("a side has nothing beyond it");
  }
}

void check_rings(const Mesh& mesh, int dimension, std::vector<std::string>& faults) {
  std::vector<std::map<std::uint32_t, std::uint32_t>> next(mesh.places.size());
  for (const Facet& facet : mesh.facets) {
    for (std::size_t i = 0; i < facet.size() && dimension == 3; ++i) {
      if (!next[facet[i]].emplace(facet[(i + 1) % 3], facet[(i + 2) % 3]).second) {
        faults.push_back("a side leaves a vertex twice");
      }
    }
    if (dimension == 3) continue;
    // The one edge that leaves a vertex, and the one that comes.
    if (!next[facet[0]].emplace(0, 1).second) faults.push_back("two edges leave a vertex");
    if (!next[facet[1]].emplace(1, 0).second) faults.push_back("two edges come to a vertex");
  }
  for (const auto& ring : next) {
    if (ring.empty()) {
      faults.push_back("a vertex is not used");
    } else if (!is_one_ring(ring)) {
      faults.push_back("around a vertex is no single ring");
    }
  }
}

void check_copies(const Mesh& mesh, int dimension, std::vector<std::string>& faults) {
  if (std::set<Place>(mesh.places.begin(), mesh.places.end()).size() != mesh.places.size()) {
    faults.push_back("two vertices are in one place");
  }
  std::set<std::set<std::uint32_t>> known;
  for (const Facet& facet : mesh.facets) {
    const std::set<std::uint32_t> corners(facet.begin(), facet.end());
    if (corners.size() != static_cast<std::size_t>(dimension)) {
      faults.push_back("a facet has the wrong number of vertices");
    }
    if (!known.insert(corners).second) faults.push_back("a facet is there twice");
  }
}

// Of the cone over a facet, from the first vertex.
double cone(const Mesh& mesh, const Facet& facet) {
  std::array<Place, 3> to{};
  for (std::size_t i = 0; i < facet.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      to[i][axis] = mesh.places[facet[i]][axis] - mesh.places[0][axis];
    }
  }
  const auto& [a, b, c] = to;
  if (facet.size() == 2) return (a[0] * b[1] - a[1] * b[0]) / 2;
  return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
          a[2] * (b[0] * c[1] - b[1] * c[0])) /
         6;
}

}  // namespace

MeshFile mesh_file(std::string_view ply, int dimension) {
  const Mesh mesh = read(ply);
  MeshFile result;
  result.facets = mesh.facets.size();
  check_copies(mesh, dimension, result.faults);
  if (!result.faults.empty()) return result;
  if (dimension == 3) check_sides(mesh, result.faults);
  check_rings(mesh, dimension, result.faults);
  for (const Facet& facet : mesh.facets) result.volume += cone(mesh, facet);
  return result;
}

}  // namespace orthoball::oracles
