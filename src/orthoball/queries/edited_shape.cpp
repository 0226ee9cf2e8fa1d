// SPDX-License-Identifier: MIT
#include "orthoball/queries/edited_shape.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "orthoball/counted.h"
#include "orthoball/error.h"
#include "orthoball/queries/regions.h"

namespace orthoball {
namespace {

[[noreturn]] void refuse(const std::string& message) {
  throw InputError(InputError::Reason::wrong_argument, InputError::kNoRow, message);
}

void check_threshold(std::optional<double> threshold, const std::string& name) {
  if (!threshold || *threshold >= 0.0) return;
  refuse("the threshold of " + name + " is " + std::to_string(*threshold) +
         "; it must be 0 or more");
}

// Cells have a volume, though it may be rounded to 0.
bool is_within(const Region& region, double threshold) {
  return region.volume <= threshold && (threshold > 0.0 || region.cells.empty());
}

template <int D>
void fill_holes(EditedShape<D>& shape, double threshold) {
  std::vector<SimplexId> simplices;
  for (const Region& hole : holes(shape.complex)) {
    if (!is_within(hole, threshold)) continue;
    simplices.insert(simplices.end(), hole.cells.begin(), hole.cells.end());
    shape.volume_filled += hole.volume;
    ++shape.holes_filled;
  }
  if (simplices.empty()) return;
  const AlphaComplex<D>& complex = shape.complex;
  const std::vector<SimplexId> known = complex.maximal_simplices();
  simplices.insert(simplices.end(), known.begin(), known.end());
  shape.complex = AlphaComplex<D>(complex.filtration(), complex.index(), simplices);
}

template <int D>
void keep_regions(EditedShape<D>& shape, std::optional<double> threshold, std::uint32_t only) {
  const Filtration<D>& filtration = shape.complex.filtration();
  const std::vector<Region> all = regions(shape.complex, JoinedBy::vertices);
  shape.region_count = all.size();
  std::vector<SiteId> kept_rows;
  std::size_t kept = 0;
  for (const Region& region : all) {
    if (threshold && is_within(region, *threshold)) {
      ++shape.regions_dropped;
      shape.volume_dropped += region.volume;
      continue;
    }
    if (++kept != only && only != 0) continue;
    kept_rows.insert(kept_rows.end(), region.rows.begin(), region.rows.end());
  }
  if (only > kept) {
    refuse("there is no region " + std::to_string(only) + "; there " +
           (kept == 1 ? "is " : "are ") + counted(kept, "region"));
  }
  if (shape.regions_dropped == 0 && (only == 0 || kept <= 1)) return;
  std::sort(kept_rows.begin(), kept_rows.end());
  std::vector<SimplexId> simplices = shape.complex.maximal_simplices();
  std::erase_if(simplices, [&](SimplexId simplex) {
    return !std::binary_search(kept_rows.begin(), kept_rows.end(), filtration.rows(simplex)[0]);
  });
  shape.complex = AlphaComplex<D>(filtration, shape.complex.index(), simplices);
}

}  // namespace

template <int D>
EditedShape<D> edited_shape(const Filtration<D>& filtration, std::uint32_t index,
                            const ShapeEdits& edits) {
  check_threshold(edits.hole_threshold, "holes");
  check_threshold(edits.region_threshold, "regions");
  EditedShape<D> shape{AlphaComplex<D>(filtration, index)};
  if (edits.regularized) shape.complex = regularized(shape.complex);
  if (edits.hole_threshold) fill_holes(shape, *edits.hole_threshold);
  if (edits.region_threshold || edits.region > 0) {
    keep_regions(shape, edits.region_threshold, edits.region);
  }
  return shape;
}

template EditedShape<2> edited_shape<2>(const Filtration<2>&, std::uint32_t, const ShapeEdits&);
template EditedShape<3> edited_shape<3>(const Filtration<3>&, std::uint32_t, const ShapeEdits&);

}  // namespace orthoball
