// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

namespace orthoball {

/// The unit cell of a crystal: from fractional to Cartesian coordinates, with the first axis along
/// x and the second in the plane of x and y. Angstrom.
class CrystalCell {
 public:
  /// @param lengths  of the three axes, Angstrom.
  /// @param angles   degrees: between the second and third axis, the first and third, the first and
  ///                 second.
  /// @return nothing unless there is such a cell: positive lengths, angles in (0, 180) that leave a
  ///         positive volume.
  [[nodiscard]] static std::optional<CrystalCell> of(const std::array<double, 3>& lengths,
                                                     const std::array<double, 3>& angles);

  /// A few roundings for each coordinate; exact zeros where angles are 90 degrees.
  [[nodiscard]] std::array<double, 3> cartesian(const std::array<double, 3>& fractional) const;

 private:
  CrystalCell() = default;
  std::array<std::array<double, 3>, 3> axes_{};  // [axis][x, y, z]
};

}  // namespace orthoball
