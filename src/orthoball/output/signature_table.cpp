// SPDX-License-Identifier: MIT
#include "orthoball/output/signature_table.h"

namespace orthoball {

template <int D>
SignatureTable<D>::SignatureTable(ByteSink& sink, SignatureFormat format)
    : sink_(sink), format_(format) {
  if (format == SignatureFormat::csv) write_signature_head_csv<D>(sink);
  if (format == SignatureFormat::json) sink.text("[");
}

template <int D>
void SignatureTable<D>::add(const SignatureRow<D>& row) {
  if (format_ == SignatureFormat::npz) return rows_.push_back(row);
  if (format_ == SignatureFormat::csv) return write_signature_csv(sink_, row);
  sink_.text(is_first_ ? "\n" : ",\n");
  is_first_ = false;
  write_signature_json(sink_, row);
}

template <int D>
void SignatureTable<D>::finish() {
  if (format_ == SignatureFormat::npz) write_signatures_npz(sink_, rows_);
  if (format_ == SignatureFormat::json) sink_.text("\n]\n");
  sink_.flush();
}

template class SignatureTable<2>;
template class SignatureTable<3>;

}  // namespace orthoball
