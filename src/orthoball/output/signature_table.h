// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "orthoball/output/tables.h"

namespace orthoball {

/// How a table of signatures is written: see write_signature_csv and the others.
enum class SignatureFormat {
  csv,   ///< a head, then a line each
  json,  ///< an array of objects, one a line
  npz,   ///< arrays for NumPy, which need all rows at once
};

/// A table of signatures, row by row as they come. Refers to the sink, whose `missing` is to be ""
/// or, for JSON, "null".
template <int D>
class SignatureTable {
 public:
  SignatureTable(ByteSink& sink, SignatureFormat format);

  /// @throws OutputError here and below.
  void add(const SignatureRow<D>& row);
  /// After the last row; flushes the sink.
  void finish();

 private:
  ByteSink& sink_;
  SignatureFormat format_;
  bool is_first_ = true;
  std::vector<SignatureRow<D>> rows_;  // of an archive
};

extern template class SignatureTable<2>;  // defined in signature_table.cpp
extern template class SignatureTable<3>;

}  // namespace orthoball
