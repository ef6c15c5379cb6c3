#include "physics/dynamics/factor.h"

#include <algorithm>

namespace tumble::dynamics {

namespace {

constexpr double kLeastPivot = 1e-14;  // of its diagonal entry

}  // namespace

void Factor::set_pattern(int size, const std::vector<std::pair<int, int>>& entries) {
  size_ = size;
  entries_ = entries;
  whole_.resize(entries.size());
  if (size <= kDense) dense_.assign(static_cast<std::size_t>(size * size), 0);
  else fronts_.analyze(size, entries);
}

void Factor::factor(const std::vector<double>& values, double regular) {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const auto [row, column] = entries_[i];
    whole_[i] = row != column ? values[i] : values[i] > 0 ? values[i] * (1 + regular) : 1;
  }
  if (size_ <= kDense) factor_dense();
  else fronts_.factor(whole_);
}

// Row by row; what is added to the diagonal keeps pivots above 0 but for rounding.
void Factor::factor_dense() {
  std::fill(dense_.begin(), dense_.end(), 0.0);
  for (std::size_t i = 0; i < entries_.size(); ++i) dense(entries_[i].first, entries_[i].second) = whole_[i];
  double left[kDense];  // L D of a row
  for (int i = 0; i < size_; ++i) {
    const double least = dense(i, i) * kLeastPivot;
    double pivot = dense(i, i);
    for (int j = 0; j < i; ++j) {
      double value = dense(i, j);
      for (int k = 0; k < j; ++k) value -= left[k] * dense(j, k);
      left[j] = value;
      dense(i, j) = value * dense(j, j);
      pivot -= value * dense(i, j);
    }
    dense(i, i) = 1 / std::max(pivot, least);
  }
}

void Factor::solve_dense(Eigen::VectorXd& x) const {
  double known[kDense];
  for (int i = 0; i < size_; ++i) {
    double value = x[i];
    for (int k = 0; k < i; ++k) value -= dense(i, k) * known[k];
    known[i] = value;
  }
  for (int i = 0; i < size_; ++i) known[i] *= dense(i, i);
  for (int i = size_ - 1; i >= 0; --i) {
    x[i] = known[i];
    for (int k = 0; k < i; ++k) known[k] -= dense(i, k) * known[i];
  }
}

void Factor::solve_in_place(Eigen::VectorXd& x) const {
  if (size_ <= kDense) solve_dense(x);
  else x = fronts_.solve(x);
}

Eigen::VectorXd Factor::solve(Eigen::VectorXd right) const {
  solve_in_place(right);
  return right;
}

}  // namespace tumble::dynamics
