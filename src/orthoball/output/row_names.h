// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "orthoball/input/site_labels.h"
#include "orthoball/output/table_writer.h"

namespace orthoball {

/// Who the rows of a table are. What the labels do not tell is empty. Refers to the labels.
class RowNames {
 public:
  explicit RowNames(const SiteLabels& labels) : labels_(&labels) {}

  /// Whether there are names of chains, residues or atoms at all: those of molecules.
  [[nodiscard]] bool has_any() const { return has_residues() || !labels_->atom.empty(); }
  [[nodiscard]] bool has_residues() const {
    return !labels_->chain.empty() || !labels_->residue.empty() || !labels_->residue_id.empty();
  }
  [[nodiscard]] std::string_view chain(std::size_t row) const {
    return label_of(labels_->chain, row);
  }
  /// Name and number with insertion code: "ALA 12", "GLY 7A".
  [[nodiscard]] std::string residue(std::size_t row) const;
  [[nodiscard]] std::string_view atom(std::size_t row) const {
    return label_of(labels_->atom, row);
  }
  [[nodiscard]] std::string_view element(std::size_t row) const {
    return label_of(labels_->element, row);
  }
  /// All in one: "A/ALA 12/CB".
  [[nodiscard]] std::string path(std::size_t row) const;

  /// The columns of a row: row, chain, residue, atom.
  /// @param suffix  of their names, where a line has several rows: "_1".
  [[nodiscard]] static std::vector<std::string> columns(const std::string& suffix = {});
  /// Their cells.
  void write(TableWriter& table, std::size_t row) const;

 private:
  const SiteLabels* labels_;
};

}  // namespace orthoball
