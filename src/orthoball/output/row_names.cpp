// SPDX-License-Identifier: MIT
#include "orthoball/output/row_names.h"

#include <cstdint>

namespace orthoball {

std::string RowNames::residue(std::size_t row) const {
  std::string text(label_of(labels_->residue, row));
  const std::string_view number = label_of(labels_->residue_id, row);
  if (!text.empty() && !number.empty()) text += ' ';
  return text.append(number);
}

std::string RowNames::path(std::size_t row) const {
  return std::string(chain(row)).append("/").append(residue(row)).append("/").append(atom(row));
}

std::vector<std::string> RowNames::columns(const std::string& suffix) {
  return {"row" + suffix, "chain" + suffix, "residue" + suffix, "atom" + suffix};
}

void RowNames::write(TableWriter& table, std::size_t row) const {
  table.integer(static_cast<std::int64_t>(row));
  table.text(chain(row));
  table.text(residue(row));
  table.text(atom(row));
}

}  // namespace orthoball
