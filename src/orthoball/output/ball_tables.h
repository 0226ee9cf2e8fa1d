// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "orthoball/input/site_labels.h"
#include "orthoball/measures/union_of_balls.h"
#include "orthoball/output/byte_sink.h"
#include "orthoball/output/table_writer.h"
#include "orthoball/points/weighted_points.h"

namespace orthoball {

// A union of balls as tables. Rows are those of the input, from 0, each with its `chain`, `residue`
// ("ALA 12") and `atom` as RowNames tells them; what labels do not tell is left out, as are numbers
// beyond the double range. In the plane volumes are areas and areas lengths of arcs.

/// `row,chain,residue,atom,element,radius,area,volume`, one line an input row. `radius` is that of
/// the ball that was measured, sqrt(weight + alpha2), none for imaginary balls. Lines of balls that
/// have no part in the union, hidden and equal ones included, end in two zeros.
/// @param points  those the union was made of.
void write_balls(ByteSink& sink, TableFormat format, const UnionOfBalls& balls,
                 const WeightedPoints& points, const SiteLabels& labels);

/// `chain,residue,atoms,area,volume`: the same summed over the rows of every residue, in the order
/// in which these come first. Rows without chain and residue are one line.
void write_residues(ByteSink& sink, TableFormat format, const UnionOfBalls& balls,
                    const SiteLabels& labels);

/// `row_1,chain_1,residue_1,atom_1,row_2,chain_2,residue_2,atom_2,area,exposed_length`, one line a
/// pair of balls that touch, in the order given.
void write_contacts(ByteSink& sink, TableFormat format, std::span<const Contact> contacts,
                    const SiteLabels& labels);

/// `chain_1,residue_1,chain_2,residue_2,pairs,area`: contacts between different residues, summed
/// over the pairs of their atoms that touch; residues in the order in which they come first.
/// @param rows  of the input.
void write_residue_contacts(ByteSink& sink, TableFormat format, std::span<const Contact> contacts,
                            std::size_t rows, const SiteLabels& labels);

/// `row,chain,residue,atom,area_by_radius,volume_by_radius,volume_by_x,..,area_by_x,..`, one line
/// an input row, with as many axes as there are. The derivative of the volume by a radius is the
/// ball's area.
/// @param balls  a union with its derivatives.
void write_derivatives(ByteSink& sink, TableFormat format, const UnionOfBalls& balls, int dimension,
                       const SiteLabels& labels);

}  // namespace orthoball
